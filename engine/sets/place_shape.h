// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/spatial_shape.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The n <= 3 numbers of v as a vector of R^3, zeros behind them.
template <class Derived>
Vector3 spatial(const Eigen::MatrixBase<Derived>& v, int n) {
  return {v[0], n > 1 ? v[1] : 0.0, n > 2 ? v[2] : 0.0};
}

/// Centres the new shape of a set of R^2 or R^3; false in other spaces.
template <class Derived>
bool place(SpatialShape& shape, const Eigen::MatrixBase<Derived>& center, int n) {
  if (n != 2 && n != 3) return false;
  shape.center = spatial(center, n);
  shape.is_centered = center.isZero(0);
  return true;
}

}  // namespace raygauge
