// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// `tangent_facets`: polytopes by N inequalities, tangent to the unit sphere at random points,
///
///     P = {x : g_i·x <= 1},   |g_i| = 1, the g_i in opposite pairs (one is left over if N is odd),
///
/// which is bounded for N >= 2n. In the role of Q it is P; in that of A it is c - P with gauge_P(c) =
/// 2 separation. With P in both roles
///
///     d = gauge_P(c) - 1 = 2 separation - 1,
///
/// since gauge_P(c - p) >= gauge_P(c) - gauge_P(p). The other set may be a cloud of N points on a unit sphere
/// instead. Throws InvalidParameterError for N < 2n.
Component<Generator> tangent_facets_generator();

}  // namespace raygauge
