// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/capsule.h"

#include <algorithm>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"

namespace raygauge {

Capsule::Capsule(const ConstVectorRef& p, const ConstVectorRef& q, double radius)
    : ConvexSet(static_cast<int>(p.size())),
      p_(checked_finite("capsule", "p", p)),
      q_(checked_finite("capsule", "q", q)),
      radius_(checked_nonnegative("capsule", "radius", radius)) {
  check_dimension("capsule", "q", q.size(), dimension());
  SpatialShape shape;
  if (!place(shape, 0.5 * p_ + 0.5 * q_, dimension())) return;
  shape.kind = SpatialShape::Kind::segment;
  shape.axis.column[0] = spatial(q_, dimension()) - shape.center;
  shape.base = spatial(p_, dimension());
  shape.top = spatial(q_, dimension());
  shape.radius = shape.inner_radius = radius_;
  shape.extent = length(shape.center) + length(shape.axis.column[0]);
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
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

double Capsule::do_inner_radius(const double* c) const {
  const int n = dimension();
  Scratch nearest(n);
  double length_squared = 0, along = 0, size = radius_;
  for (int k = 0; k < n; ++k) {
    const double axis_k = q_[k] - p_[k];
    length_squared += axis_k * axis_k;
    along += axis_k * (c[k] - p_[k]);
    size += std::fabs(c[k]) + std::fabs(p_[k]) + std::fabs(q_[k]);
  }
  const double t = length_squared > 0 ? std::clamp(along / length_squared, 0.0, 1.0) : 0.0;
  for (int k = 0; k < n; ++k) nearest.data()[k] = (1 - t) * p_[k] + t * q_[k];
  return proven_length(radius_ - distance_between(nearest.data(), c, n), size, n);
}

SupportStructure Capsule::do_structure() const noexcept { return SupportStructure::smooth; }

template <class Real>
void Capsule::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  if (capacity < 2) return;
  const int n = dimension();
  Real* unit = pieces.point(0);
  const Real length = normalize(u, n, unit);
  norm_hessian(unit, radius_ / length, n, pieces.hessian(0));
  std::copy_n(pieces.hessian(0), n * n, pieces.hessian(1));
  for (int k = 0; k < n; ++k) pieces.point(1)[k] = q_[k] + radius_ * unit[k];
  for (int k = 0; k < n; ++k) unit[k] = p_[k] + radius_ * unit[k];
  pieces.value[0] = dot(u, p_.data(), n) + radius_ * length;
  pieces.value[1] = dot(u, q_.data(), n) + radius_ * length;
  pieces.count = 2;
}

void Capsule::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void Capsule::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

}  // namespace raygauge
