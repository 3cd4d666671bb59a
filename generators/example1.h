// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// `example1`: Example 1 of Zheng & Yamane, a truncated cone and an ellipsoid of R^n (n >= 2; the paper's is
/// 3) with random sizes, orientations and relative position, placed in contact; then Q is scaled about the
/// origin by 1/distance. `roles` says which of the two is A. Q's centre is the origin, so that
///
///     d_Q(A) = distance,    true for the doubles that are emitted to a relative 2^-46 (docs/generators.md).
///
/// The paper gives no distributions. Here, in the order in which they are drawn:
///
///     ellipsoid   semi-axes uniform on [1/2, 3/2], orientation uniform (Haar);
///     cone        base radius r and height uniform on [1/2, 3/2], top radius uniform on [0, r], axis
///     uniform; contact     the point p of the cone's surface on the ray from its centre (the middle of its
///     axis) in a uniform
///                 direction, with the outward normal v there: s_ellipsoid(-v) is put on p.
///
/// N is ignored. All distances and both roles of one key share the pair of bodies.
Component<Generator> example1_generator();

}  // namespace raygauge
