// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/polytopes.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/decompositions.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"

namespace raygauge {
namespace {

// Σ|u·g_i| >= |Gᵀu| >= √λ |u|, λ the least eigenvalue of G Gᵀ, less what rounding may have added to it.
double inner_radius_about_center(const Eigen::MatrixXd& G) {
  const Eigen::MatrixXd M = G * G.transpose();
  if (!(M.trace() > 0 && M.trace() < kHugeSquare)) return 0;
  const auto size = static_cast<double>(G.rows() + G.cols());
  const double least = least_eigenvalue(M) - 64 * size * kUnitRoundoff * M.trace();
  return least > 0 ? std::sqrt(least) * (1 - 4 * kUnitRoundoff) : 0;
}

}  // namespace

Zonotope::Zonotope(const ConstVectorRef& center, const Eigen::Ref<const Eigen::MatrixXd>& generators)
    : ConvexSet(static_cast<int>(center.size())),
      center_(checked_finite("zonotope", "center", center)),
      generators_(generators) {
  check_finite_matrix("zonotope", "generators", generators);
  check_dimension("zonotope", "generators", generators.rows(), dimension());
  // A sum of m products loses more than the 2n + 8 roundings that magnitudes stand for.
  const double n = dimension();
  const double longer = std::max(1.0, (n + static_cast<double>(generators_.cols()) + 8) / (2 * n + 8));
  magnitude_ = longer * (center_.cwiseAbs() + generators_.cwiseAbs().rowwise().sum());
  radius_ = inner_radius_about_center(generators_);
}

double Zonotope::do_support(const double* u, double* point) const {
  const int n = dimension();
  std::copy_n(center_.data(), n, point);
  double value = dot(u, center_.data(), n);
  for (Eigen::Index i = 0; i < generators_.cols(); ++i) {
    const double* g = generators_.data() + i * n;
    const double along = dot(u, g, n);
    const double sign = along < 0 ? -1.0 : 1.0;
    value += sign * along;
    for (int k = 0; k < n; ++k) point[k] += sign * g[k];
  }
  return value;
}

void Zonotope::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void Zonotope::do_magnitude(double* magnitude) const { Vector::Map(magnitude, dimension()) = magnitude_; }

double Zonotope::do_inner_radius(const double* c) const {
  const double away = distance_between(center_.data(), c, dimension());
  return proven_length(radius_ - away, radius_ + 2 * away + center_.lpNorm<1>(), dimension());
}

}  // namespace raygauge
