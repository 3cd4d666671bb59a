// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/triangle_normal.h"

namespace raygauge {

/// The smallest face of a simplex that holds its point nearest to the origin.
template <class Real>
struct SimplexFace {
  int count = 0;
  int corner[4] = {0, 0, 0, 0};  ///< ascending
  Real weight[4] = {};  ///< barycentric coordinates of that point; their sum is 1 to 8 rounding units
  BasicVector3<Real> v;
  Real square{};
  double depth = 0;  ///< the ball of this radius about the origin is inside, proven; 0: nothing is
};

/// Of `count` <= 4 points. Where the origin is inside four points, all of them with its coordinates and
/// depth. Rounding may choose another face: what is concluded from one must not rely on its being the
/// nearest. The depth is a lower bound, rounding included.
template <class Real>
SimplexFace<Real> nearest_face(const BasicVector3<Real>* const* points, int count);

template <>
SimplexFace<double> nearest_face(const Vector3* const* points, int count);
template <>
SimplexFace<DoubleDouble> nearest_face(const BasicVector3<DoubleDouble>* const* points, int count);

}  // namespace raygauge
