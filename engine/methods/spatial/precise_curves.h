// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_pair.h"
#include "engine/numerics/precise_vector.h"

namespace raygauge {

/// A direction v as the rims of a frustum see it: v·axis, |v_⊥| and v_⊥, zero for v along the axis.
struct RimView {
  DoubleDouble along, across;
  PreciseVector3 w;
  bool near_axis = false;  ///< rims are as good as flat: points on them are kept

  RimView(const SpatialShape& shape, const PreciseVector3& v) {
    const PreciseVector3 axis = precise(shape.top) - precise(shape.base);
    const DoubleDouble square = dot(axis, axis);
    const double size = length(rounded(v));
    along = dot(v, axis);
    w = v - axis * (along / square);
    constexpr double kCancelled = 0.1;  // |v_⊥|/|v| below which the projection is repeated
    if (!(length(rounded(w)) > kCancelled * size)) w = w - axis * (dot(w, axis) / square);
    across = sqrt(dot(w, w));
    constexpr double kAlongAxis = 1e-28;  // |v_⊥|/|v| that is nothing but rounding
    if (!(across.high > kAlongAxis * size)) w = {};
    constexpr double kNearAxis = 1e-5;
    near_axis = !(across.high > kNearAxis * size);
  }

  std::int32_t highest(const SpatialShape& shape) const {
    const DoubleDouble rise = along + across * two_sum(shape.top_radius, -shape.base_radius);
    return rise.high > 0 ? SpatialPoint::kTop : SpatialPoint::kBase;
  }

  PreciseVector3 point(const SpatialShape& shape, std::int32_t index) const {
    const bool top = index == SpatialPoint::kTop;
    const PreciseVector3 center = precise(top ? shape.top : shape.base);
    if (w.x.high == 0 && w.y.high == 0 && w.z.high == 0) return center;
    return center + w * (DoubleDouble{top ? shape.top_radius : shape.base_radius} / across);
  }

  DoubleDouble height(const SpatialShape& shape, const PreciseVector3& v, std::int32_t index) const {
    return index == SpatialPoint::kTop ? dot(v, shape.top) + across * shape.top_radius
                                       : dot(v, shape.base) + across * shape.base_radius;
  }
};

/// h(v) of an ellipsoid, v·c + |Lᵀv|, and its point c + L Lᵀv/|Lᵀv| where x is asked for.
inline DoubleDouble ellipsoid_support(const SpatialShape& shape, const PreciseVector3& v, PreciseVector3* x) {
  const Vector3* L = shape.axis.column;
  const PreciseVector3 z{dot(v, L[0]), dot(v, L[1]), dot(v, L[2])};
  const DoubleDouble size = sqrt(dot(z, z));
  if (x != nullptr) {
    *x = precise(shape.center);
    if (size.high > 0) {
      const PreciseVector3 on_ball = z * (DoubleDouble{1} / size);
      const Vector3 row[3] = {{L[0].x, L[1].x, L[2].x}, {L[0].y, L[1].y, L[2].y}, {L[0].z, L[1].z, L[2].z}};
      *x = *x + PreciseVector3{dot(on_ball, row[0]), dot(on_ball, row[1]), dot(on_ball, row[2])};
    }
  }
  return dot(v, shape.center) + size;
}

}  // namespace raygauge
