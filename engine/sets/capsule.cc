// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/capsule.h"

#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

Capsule::Capsule(const ConstVectorRef& p, const ConstVectorRef& q, double radius)
    : ConvexSet(static_cast<int>(p.size())),
      p_(checked_finite("capsule", "p", p)),
      q_(checked_finite("capsule", "q", q)),
      radius_(checked_nonnegative("capsule", "radius", radius)) {
  check_dimension("capsule", "q", q.size(), dimension());
}

double Capsule::do_support(const double* u, double* point) const {
  const int n = dimension();
  const double along_p = dot(u, p_.data(), n);
  const double along_q = dot(u, q_.data(), n);
  const Vector& end = along_q > along_p ? q_ : p_;
  const double length = normalize(u, n, point);
  for (int k = 0; k < n; ++k) point[k] = end[k] + radius_ * point[k];
  return std::max(along_p, along_q) + radius_ * length;
}

void Capsule::do_center(double* point) const { Vector::Map(point, dimension()) = 0.5 * p_ + 0.5 * q_; }

void Capsule::do_magnitude(double* magnitude) const {
  Vector::Map(magnitude, dimension()) = p_.cwiseAbs().cwiseMax(q_.cwiseAbs()).array() + radius_;
}

}  // namespace raygauge
