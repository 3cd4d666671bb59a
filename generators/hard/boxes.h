// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// A is a point, a box or a homothet of Q, with integer coordinates; Q is a body of polytopes.h. N is ignored.

/// `hard_point`: A = {p}, p random integers up to 1000 in size. d = gauge_Q(p).
Component<Generator> hard_point_generator();

/// `hard_box`: A = c ± h, c and h random integers, |c_1| > h_1. d = gauge of the point of A nearest to 0
/// coordinate by coordinate: Σ_k (|c_k| - h_k)₊ for a cross-polytope Q, max_k for a cube. The minimiser is
/// seldom unique. n <= 12.
Component<Generator> hard_box_generator();

/// `hard_lattice`: A = o + {0, …, k}^n, o random integers with o_1 >= 1: collinear and interior points, zero
/// pivots. d as for hard_box. At most 2^16 points.
Component<Generator> hard_lattice_generator();

/// `hard_far`: A = c - Q, c_k = ±(offset + random integer up to 1000). d = gauge_Q(c) - 1.
Component<Generator> hard_far_generator();

}  // namespace raygauge
