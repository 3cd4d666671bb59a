// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/ball.h"

#include "engine/numerics/exact_sum.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"

namespace raygauge {

Ball::Ball(const ConstVectorRef& center, double radius)
    : ConvexSet(static_cast<int>(center.size())),
      center_(checked_finite("ball", "center", center)),
      radius_(checked_nonnegative("ball", "radius", radius)) {
  SpatialShape shape;
  if (!place(shape, center_, dimension())) return;
  shape.kind = SpatialShape::Kind::point;
  shape.radius = shape.inner_radius = radius_;
  shape.extent = length(shape.center);
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
}

double Ball::do_support(const double* u, double* point) const {
  const double length = normalize(u, dimension(), point);
  for (int k = 0; k < dimension(); ++k) point[k] = center_[k] + radius_ * point[k];
  return dot(u, center_.data(), dimension()) + radius_ * length;
}

void Ball::do_center(double* point) const { Vector::Map(point, dimension()) = center_; }

void Ball::do_magnitude(double* magnitude) const {
  Vector::Map(magnitude, dimension()) = center_.cwiseAbs().array() + radius_;
}

double Ball::do_inner_radius(const double* c) const {
  const double away = distance_between(center_.data(), c, dimension());
  return proven_length(radius_ - away, radius_ + 2 * away + center_.lpNorm<1>(), dimension());
}

// t is the least root >= 0 of |x - tc| = tr, written without cancellation; x - tc is the normal.
bool Ball::do_quad_gauge_normal(const Quad* x, Quad* normal) const {
  const int n = dimension();
  const Quad along = dot(x, center_.data(), n);
  const Quad square = dot(x, x, n);
  Quad inside = Quad{radius_} * radius_;  // r² - |c|²
  for (int k = 0; k < n; ++k) inside -= Quad{center_[k]} * center_[k];
  const Quad discriminant = along * along + inside * square;
  if (!(discriminant >= 0)) return false;
  const Quad denominator = along + elementary::sqrt(discriminant);
  if (!(denominator > 0)) return false;
  for (int k = 0; k < n; ++k) normal[k] = x[k] - square / denominator * center_[k];
  return true;
}

// |c|² = r² > 0, exactly.
bool Ball::do_touches_origin(double* u) const {
  ExactSum difference;
  difference.add_product(radius_, -radius_);
  for (int k = 0; k < dimension(); ++k) {
    difference.add_product(center_[k], center_[k]);
    u[k] = -center_[k];
  }
  return radius_ > 0 && difference.is_zero();
}

SupportStructure Ball::do_structure() const noexcept { return SupportStructure::smooth; }

template <class Real>
void Ball::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  if (capacity < 1) return;
  const int n = dimension();
  Real* point = pieces.point(0);
  const Real length = normalize(u, n, point);
  norm_hessian(point, radius_ / length, n, pieces.hessian(0));
  for (int k = 0; k < n; ++k) point[k] = center_[k] + radius_ * point[k];
  pieces.value[0] = dot(u, center_.data(), n) + radius_ * length;
  pieces.count = 1;
}

void Ball::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void Ball::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

}  // namespace raygauge
