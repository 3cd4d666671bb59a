// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/box.h"

#include <algorithm>
#include <limits>
#include <string>

#include "engine/numerics/number_text.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"
#include "raygauge/exceptions.h"

namespace raygauge {

Box::Box(const ConstVectorRef& lower, const ConstVectorRef& upper)
    : ConvexSet(static_cast<int>(lower.size())),
      lower_(checked_finite("box", "lower", lower)),
      upper_(checked_finite("box", "upper", upper)) {
  check_dimension("box", "upper", upper.size(), dimension());
  for (int k = 0; k < dimension(); ++k) {
    if (lower_[k] > upper_[k]) {
      throw InvalidParameterError("box: coordinate " + std::to_string(k) + " of lower, " +
                                  shortest_text(lower_[k]) + ", must not exceed that of upper, " +
                                  shortest_text(upper_[k]));
    }
  }
  SpatialShape shape;
  if (!place(shape, 0.5 * lower_ + 0.5 * upper_, dimension())) return;
  const Vector3 half = spatial(upper_, dimension()) - shape.center;
  shape.kind = SpatialShape::Kind::box;
  shape.axis.column[0] = half;
  shape.base = spatial(lower_, dimension());
  shape.top = spatial(upper_, dimension());
  shape.inner_radius = std::min({half.x, half.y, dimension() == 3 ? half.z : half.x});
  shape.extent = length(shape.center) + length(half);
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
}

double Box::do_support(const double* u, double* point) const {
  double value = 0;
  for (int k = 0; k < dimension(); ++k) {
    point[k] = u[k] > 0 ? upper_[k] : lower_[k];
    value += u[k] * point[k];
  }
  return value;
}

void Box::do_center(double* point) const { Vector::Map(point, dimension()) = 0.5 * lower_ + 0.5 * upper_; }

void Box::do_magnitude(double* magnitude) const {
  Vector::Map(magnitude, dimension()) = lower_.cwiseAbs().cwiseMax(upper_.cwiseAbs());
}

double Box::do_inner_radius(const double* c) const {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < dimension(); ++k) least = std::min({least, upper_[k] - c[k], c[k] - lower_[k]});
  return std::max(0.0, least * (1 - std::numeric_limits<double>::epsilon()));
}

SupportStructure Box::do_structure() const noexcept { return SupportStructure::polytope; }

}  // namespace raygauge
