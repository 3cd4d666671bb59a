// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// Where the origin lies decides the answer: d = 0, d = +infinity, or finite against the odds. N is ignored;
// the axes are turned at random.

/// `hard_origin_in_object`: A = conv{c ± r e_k} in integers, with 0 in its `place`: interior (r > ‖c‖₁), on a
/// face (r = ‖c‖₁) or at a vertex (c = -r e_1). d = 0.
Component<Generator> hard_origin_in_object_generator();

/// `hard_origin_on_boundary`: Q = conv{2e_1, ±e_2, …, ±e_n} has 0 on its boundary. A = {3e_1 + e_2}: d = 5/2;
/// with `reachable` = false A = {-1e-9 e_1 + ½e_2}: d = +infinity. n >= 2.
Component<Generator> hard_origin_on_boundary_generator();

/// `hard_origin_outside`: Q = conv{2e_1, e_1 ± e_2, …, e_1 ± e_n}, which does not contain 0. A = {3e_1 +
/// e_2}: d = 2; with `reachable` = false A = {e_1 + 3e_2}: d = +infinity. n >= 2.
Component<Generator> hard_origin_outside_generator();

/// `hard_flat`: Q = conv{±e_1, …, ±e_{n-1}} is flat. A = conv{3e_1 - δe_n, 5e_1 + δe_n} crosses its plane at
/// 4e_1: d = 4; with `crossing` = false A = conv{3e_1 + δe_n, 5e_1 + δe_n}: d = +infinity. n >= 2.
Component<Generator> hard_flat_generator();

}  // namespace raygauge
