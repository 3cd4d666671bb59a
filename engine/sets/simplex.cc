// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/polytopes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/double_double.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"

namespace raygauge {
namespace {

// o and o + a_k e_k, unless one of them is rounded.
std::unique_ptr<const PointSet> exact_vertices(const Vector& corner, const Vector& legs) {
  const Eigen::Index n = corner.size();
  if (n != 2 && n != 3) return nullptr;
  DenseMatrix vertices = corner.replicate(1, n + 1);
  for (Eigen::Index k = 0; k < n; ++k) {
    const DoubleDouble end = two_sum(corner[k], legs[k]);
    if (end.low != 0 || !std::isfinite(end.high)) return nullptr;
    vertices(k, k + 1) = end.high;
  }
  return std::make_unique<const PointSet>(vertices);
}

}  // namespace

Simplex::Simplex(const ConstVectorRef& corner, const ConstVectorRef& legs)
    : ConvexSet(static_cast<int>(corner.size())),
      corner_(checked_finite("simplex", "corner", corner)),
      legs_(checked_finite("simplex", "legs", legs)) {
  check_dimension("simplex", "legs", legs.size(), dimension());
  vertices_ = exact_vertices(corner_, legs_);
  if (!vertices_) return;
  SpatialShape shape = *vertices_->spatial_shape();
  Vector center(dimension());
  Simplex::do_center(center.data());
  place(shape, center, dimension());
  shape.inner_radius = Simplex::do_inner_radius(center.data());
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
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

// The faces are x_k = o_k and Σ (x_k - o_k)/a_k = 1, each kept on the side of the simplex.
double Simplex::do_inner_radius(const double* c) const {
  double least = std::numeric_limits<double>::infinity();
  const double shortest = legs_.cwiseAbs().minCoeff();
  double across = 1, steepness = 0, size = 0;  // steepness: of the slanted face, times shortest²
  for (int k = 0; k < dimension(); ++k) {
    if (legs_[k] == 0) return 0;
    const double along = (c[k] - corner_[k]) / legs_[k];
    least = std::min(least, along * std::fabs(legs_[k]));
    across -= along;
    steepness += (shortest / legs_[k]) * (shortest / legs_[k]);
    size += std::fabs(c[k]) + std::fabs(corner_[k]) + std::fabs(legs_[k]);
  }
  const double left = across - 4 * dimension() * std::numeric_limits<double>::epsilon();
  least = std::min(least, shortest * left / std::sqrt(steepness));
  return proven_length(least, size, dimension());
}

SupportStructure Simplex::do_structure() const noexcept { return SupportStructure::polytope; }

}  // namespace raygauge
