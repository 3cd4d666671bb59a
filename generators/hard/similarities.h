// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "generators/random.h"

namespace raygauge {

// Orientations without rounding: every rotation below is by angles of the triangle 3, 4, 5, and scaled by 5
// for each, so that integers stay integers.

/// x rounded to a multiple of 2^-36, so that there is room for products with integers of 16 bits.
double on_grid(double x);

/// A random integer matrix M, n × n, with MᵀM = 25^layers: a rotation or reflection, times 5^layers. A layer
/// turns the coordinates in random pairs; columns have up to 2^layers entries that are not zero.
Eigen::MatrixXd integer_similarity(RandomStream& stream, int n, int layers);

/// Two orthogonal integer vectors of the same integer length, in a random position: the axis of a body of
/// revolution and a direction across it. The point at height z with distance ρ from the axis is
/// z · along + ρ · across; lengths are measured in units of `unit`.
struct HalfPlane {
  Vector along;
  Vector across;
  double unit = 0;  ///< |along| = |across|

  Vector point(double height, double away) const { return height * along + away * across; }
};

/// unit = 5^(axis_layers + layers_across). n >= 2.
HalfPlane random_half_plane(RandomStream& stream, int n, int axis_layers, int layers_across);

}  // namespace raygauge
