// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// `random_segments`: zonotopes Z = {Σ t_i g_i : |t_i| <= 1} of N random generators,
///
///     g_i uniform on the sphere of radius sqrt(π n / 2) / N,
///
/// so that h_Z is about 1 (1.09 in R^3): the more segments, the rounder. Q is about 0, A about c, in a random
/// direction w,
///
///     c = separation (h_A(-w) + h_Q(w)) w,      h of both sets about 0,
///
/// for which w proves d > 1 (separation > 1). One of the two sets may be a cloud of N points on a unit sphere
/// instead. Throws InvalidParameterError for N < n, which is flat.
Component<Generator> random_segments_generator();

}  // namespace raygauge
