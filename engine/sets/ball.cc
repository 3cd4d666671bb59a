// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/ball.h"

#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

Ball::Ball(const ConstVectorRef& center, double radius)
    : ConvexSet(static_cast<int>(center.size())),
      center_(checked_finite("ball", "center", center)),
      radius_(checked_nonnegative("ball", "radius", radius)) {}

double Ball::do_support(const double* u, double* point) const {
  const double length = normalize(u, dimension(), point);
  for (int k = 0; k < dimension(); ++k) point[k] = center_[k] + radius_ * point[k];
  return dot(u, center_.data(), dimension()) + radius_ * length;
}

void Ball::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void Ball::do_magnitude(double* magnitude) const {
  Vector::Map(magnitude, dimension()) = center_.cwiseAbs().array() + radius_;
}

}  // namespace raygauge
