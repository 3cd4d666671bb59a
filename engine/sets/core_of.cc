// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/core_of.h"

#include <algorithm>
#include <cmath>

#include "engine/sets/spatial_shape.h"

namespace raygauge {

double CoreOf::do_support(const double* u, double* point) const {
  SpatialShape shape;
  const double radius = set_.spatial_shape_unchecked(shape) ? shape.radius : 0.0;
  const double height = set_.support_unchecked(u, point);
  double square = 0;
  for (int k = 0; k < dimension(); ++k) square += u[k] * u[k];
  const double size = std::sqrt(square);
  for (int k = 0; size > 0 && k < dimension(); ++k) point[k] -= radius / size * u[k];
  return height - radius * size;
}

// A ball inside core + r B is one of radius r larger than one inside the core: for closed convex sets
// summands may be cancelled.
bool CoreOf::do_spatial_shape(SpatialShape& shape) const {
  if (!set_.spatial_shape_unchecked(shape)) return false;
  shape.inner_radius = std::max(0.0, shape.inner_radius - shape.radius * (1 + 0x1p-50));
  shape.radius = 0;
  return true;
}

}  // namespace raygauge
