// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/simplex.h"

#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

Simplex::Simplex(const ConstVectorRef& corner, const ConstVectorRef& legs)
    : ConvexSet(static_cast<int>(corner.size())),
      corner_(checked_finite("simplex", "corner", corner)),
      legs_(checked_finite("simplex", "legs", legs)) {
  check_dimension("simplex", "legs", legs.size(), dimension());
}

double Simplex::do_support(const double* u, double* point) const {
  int best = -1;
  double gain = 0;
  for (int k = 0; k < dimension(); ++k) {
    const double along_leg = legs_[k] * u[k];
    if (along_leg > gain) {
      gain = along_leg;
      best = k;
    }
  }
  std::copy_n(corner_.data(), dimension(), point);
  if (best >= 0) point[best] += legs_[best];
  return dot(u, corner_.data(), dimension()) + gain;
}

void Simplex::do_center(double* point) const {
  Vector::Map(point, dimension()) = corner_ + legs_ / (dimension() + 1.0);
}

void Simplex::do_magnitude(double* magnitude) const {
  Vector::Map(magnitude, dimension()) = corner_.cwiseAbs() + legs_.cwiseAbs();
}

}  // namespace raygauge
