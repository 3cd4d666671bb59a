// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// Ties by construction: optimal faces of high dimension, normals that are not unique. N is ignored.

/// `hard_cross_polytope`: A = conv{c ± r e_k} against the cube, with the integers c, t and
/// r = Σ_k (|c_k| - t)₊ > 0. d = t: that is how far the cube must grow for ‖c‖₁'s excess to shrink to r. n
/// <= 12.
Component<Generator> hard_cross_polytope_generator();

/// `hard_scaled_simplex`: A = conv{s e_k}, s = n · level. d = s against the cross-polytope (all of A is
/// optimal), s/n = level against the cube. The axes are turned at random.
Component<Generator> hard_scaled_simplex_generator();

/// `hard_vertex`: A = {λ v}, v a vertex or the midpoint of an edge of Q: every normal of v's cone is valid.
/// d = λ. n >= 2.
Component<Generator> hard_vertex_generator();

}  // namespace raygauge
