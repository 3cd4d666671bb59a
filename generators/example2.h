// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// `example2`: Example 2 of Zheng & Yamane. N random points on each of two separated unit spheres of R^n,
///
///     Q = conv{q_1, …, q_N},  |q_j| = 1,      A = conv{a_1, …, a_N},  |a_i - c| = 1,  |c| = 2 · separation,
///
/// with the points and the direction of c uniform on the sphere. Hence d_Q(A) > 1. Nothing forces 0 into the
/// interior of Q: with N points in R^n it lies outside with probability 2^(1-N) Σ_{k<n} C(N-1, k) (Wendel),
/// and then d may be +infinity. That is below 1e-40 for N >= 200, n <= 10, but not for N near n.
Component<Generator> example2_generator();

}  // namespace raygauge
