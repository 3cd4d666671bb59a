// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "raygauge/sets/spatial_shape.h"

namespace raygauge {

inline constexpr double kAlongAxis = 1e-14;  // |v_⊥|/|v| that is nothing but rounding

/// The unit vector across the axis of a frustum that is nearest to v, or zero; and how far v goes across.
inline Vector3 across_axis(const SpatialShape& shape, const Vector3& v, double& across) {
  const Vector3& a = shape.axis.column[0];
  Vector3 w = v - a * dot(v, a);
  w = w - a * dot(w, a);
  const double square = dot(w, w);
  across = std::sqrt(square);
  if (square > kAlongAxis * kAlongAxis * dot(v, v)) return w * (1 / across);
  across = 0;
  return {};
}

/// w (1 - a aᵀ - b bᵀ) for unit vectors a and b, b perhaps zero, added to H.
inline void add_projector(double w, const Vector3& a, const Vector3& b, Matrix3& H) {
  H.column[0] = H.column[0] + Vector3{w, 0, 0} - a * (w * a.x) - b * (w * b.x);
  H.column[1] = H.column[1] + Vector3{0, w, 0} - a * (w * a.y) - b * (w * b.y);
  H.column[2] = H.column[2] + Vector3{0, 0, w} - a * (w * a.z) - b * (w * b.z);
}

/// L Lᵀ.
inline Matrix3 square_of(const Matrix3& L) {
  return {{L * Vector3{L.column[0].x, L.column[1].x, L.column[2].x},
           L * Vector3{L.column[0].y, L.column[1].y, L.column[2].y},
           L * Vector3{L.column[0].z, L.column[1].z, L.column[2].z}}};
}

/// share (L Lᵀ - y yᵀ), added to H: with y = L Lᵀu/|Lᵀu| and share = 1/|Lᵀu| the Hessian of |Lᵀu|.
inline void add_ellipsoid_hessian(const Matrix3& square, const Vector3& y, double share, Matrix3& H) {
  H.column[0] = H.column[0] + (square.column[0] - y * y.x) * share;
  H.column[1] = H.column[1] + (square.column[1] - y * y.y) * share;
  H.column[2] = H.column[2] + (square.column[2] - y * y.z) * share;
}

}  // namespace raygauge
