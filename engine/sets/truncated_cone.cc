// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/truncated_cone.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/vector_kernels.h"
#include "engine/sets/axis.h"
#include "engine/sets/parameters.h"
#include "engine/sets/place_shape.h"

namespace raygauge {
namespace {

// How near the axis a way must pass, as a share of where it began, for the axis to be worth a query.
constexpr double kPassesBy = 0.5;

}  // namespace

Frustum::Frustum(const std::string& set, const ConstVectorRef& base, double base_radius,
                 const ConstVectorRef& top, double top_radius)
    : ConvexSet(static_cast<int>(base.size())),
      axis_(std::make_shared<const Axis>(set, base, top)),
      base_(base),
      top_(top),
      base_radius_(base_radius),
      top_radius_(top_radius) {
  Vector center(dimension());
  Frustum::do_center(center.data());
  const double inner_radius = Frustum::do_inner_radius(center.data());
  const int n = dimension();
  SpatialShape shape;
  if (n < 2 || n > 3 || !place(shape, center, n)) return;
  shape.kind = SpatialShape::Kind::frustum;
  shape.axis.column[0] = spatial(axis_->direction(), n);
  shape.base = spatial(base_, n);
  shape.top = spatial(top_, n);
  shape.base_radius = base_radius_;
  shape.top_radius = top_radius_;
  shape.full = dot(shape.top - shape.base, shape.axis.column[0]);
  shape.side_along = (base_radius_ - top_radius_) / std::hypot(shape.full, base_radius_ - top_radius_);
  shape.side_across = shape.full / std::hypot(shape.full, base_radius_ - top_radius_);
  shape.inner_radius = inner_radius;
  shape.extent = std::max(length(shape.base), length(shape.top)) + std::max(base_radius_, top_radius_);
  set_spatial_shape(std::make_shared<const SpatialShape>(shape));
}

double Frustum::do_support(const double* u, double* point) const {
  const int n = dimension();
  const double across = axis_->radial_part(u, point);
  const double base_value = dot(u, base_.data(), n) + base_radius_ * across;
  const double top_value = dot(u, top_.data(), n) + top_radius_ * across;
  const bool at_top = top_value > base_value;
  const Vector& disc = at_top ? top_ : base_;
  const double radius = at_top ? top_radius_ : base_radius_;
  for (int k = 0; k < n; ++k) point[k] = disc[k] + radius * point[k];
  return at_top ? top_value : base_value;
}

void Frustum::do_center(double* point) const { Vector::Map(point, dimension()) = 0.5 * base_ + 0.5 * top_; }

void Frustum::do_magnitude(double* magnitude) const {
  const Vector& a = axis_->direction();
  const double share = 4 * a.lpNorm<1>();  // of the axis in the rounding errors of u_⊥
  Vector::Map(magnitude, dimension()) = base_.cwiseAbs().cwiseMax(top_.cwiseAbs()).array() +
                                        std::max(base_radius_, top_radius_) * (2 + share * a.array().abs());
}

// The distances of c from the two planes and from the nappe, which is z -> R(z) = r_b - k z in the half-plane
// of c and the axis.
double Frustum::do_inner_radius(const double* c) const {
  const int n = dimension();
  const double* a = axis_->direction().data();
  Scratch offset(n), radial(n);
  double size = base_radius_ + top_radius_;
  double height = 0;
  for (int k = 0; k < n; ++k) {
    offset.data()[k] = c[k] - base_[k];
    size += std::fabs(c[k]) + std::fabs(base_[k]) + std::fabs(top_[k]);
    height += (top_[k] - base_[k]) * a[k];
  }
  if (!(height > 0)) return 0;
  const double z = dot(offset.data(), a, n);
  const double away = axis_->radial_part(offset.data(), radial.data());
  const double slope = (base_radius_ - top_radius_) / height;
  const double to_nappe = (base_radius_ - slope * z - away) / std::sqrt(1 + slope * slope);
  return proven_length(std::min({z, height - z, to_nappe}), size, n);
}

// Base first.
template <class Real>
void Frustum::list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
  if (capacity < 2) return;
  const int n = dimension();
  const Real* a = axis_->components<Real>();
  Real* unit = pieces.point(0);
  Real* H_b = pieces.hessian(0);
  Real* H_t = pieces.hessian(1);
  const Real across = axis_->radial_part(u, unit);
  const Real curvature = across > 0 ? 1 / across : Real{0};
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) {
      const Real projector = (j == k ? 1 : 0) - a[j] * a[k] - unit[j] * unit[k];
      H_b[j * n + k] = base_radius_ * curvature * projector;
      H_t[j * n + k] = top_radius_ * curvature * projector;
    }
  }
  for (int k = 0; k < n; ++k) pieces.point(1)[k] = top_[k] + top_radius_ * unit[k];
  for (int k = 0; k < n; ++k) unit[k] = base_[k] + base_radius_ * unit[k];
  pieces.value[0] = dot(u, base_.data(), n) + base_radius_ * across;
  pieces.value[1] = dot(u, top_.data(), n) + top_radius_ * across;
  pieces.count = 2;
}

// The axis, of the sign that u points to, if the way from u to v passes it by closely.
template <class Real>
bool Frustum::find_facet_normal(const Real* u, const Real* v, Real* normal) const {
  const int n = dimension();
  const Real* a = axis_->components<Real>();
  const Real along_u = dot(u, a, n);
  const Real along_v = dot(v, a, n);
  Real begin = 0, way = 0, progress = 0;  // |u_⊥|², |v_⊥ - u_⊥|², -u_⊥·(v_⊥ - u_⊥)
  for (int k = 0; k < n; ++k) {
    const Real u_k = u[k] - along_u * a[k];
    const Real step_k = v[k] - along_v * a[k] - u_k;
    begin += u_k * u_k;
    way += step_k * step_k;
    progress -= u_k * step_k;
  }
  if (!(progress > 0)) return false;
  const Real t = std::min(Real{1}, progress / way);
  const Real nearest = begin - t * (2 * progress - t * way);
  const Real along = along_u + t * (along_v - along_u);
  const double radius = along > 0 ? top_radius_ : base_radius_;
  if (!(radius > 0) || nearest > kPassesBy * kPassesBy * begin) return false;
  for (int k = 0; k < n; ++k) normal[k] = along > 0 ? a[k] : -a[k];
  return true;
}

template <class Real>
void Frustum::find_facet_point(const Real* normal, const Real* target, Real* point) const {
  const int n = dimension();
  const bool at_top = dot(normal, axis_->components<Real>(), n) > 0;
  const Vector& disc = at_top ? top_ : base_;
  BasicScratch<Real> offset(n);
  for (int k = 0; k < n; ++k) offset.data()[k] = target[k] - disc[k];
  const Real radius = at_top ? top_radius_ : base_radius_;
  const Real away = std::min(axis_->radial_part(offset.data(), point), radius);
  for (int k = 0; k < n; ++k) point[k] = disc[k] + away * point[k];
}

SupportStructure Frustum::do_structure() const noexcept { return SupportStructure::smooth; }

void Frustum::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

void Frustum::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  list_pieces(u, pieces, capacity);
}

bool Frustum::do_facet_normal(const double* u, const double* v, double* normal) const {
  return find_facet_normal(u, v, normal);
}

bool Frustum::do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const {
  return find_facet_normal(u, v, normal);
}

void Frustum::do_facet_point(const double* normal, const double* target, double* point) const {
  find_facet_point(normal, target, point);
}

void Frustum::do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const {
  find_facet_point(normal, target, point);
}

TruncatedCone::TruncatedCone(const ConstVectorRef& base, double base_radius, const ConstVectorRef& top,
                             double top_radius)
    : Frustum("truncated cone", base, checked_nonnegative("truncated cone", "base_radius", base_radius), top,
              checked_nonnegative("truncated cone", "top_radius", top_radius)) {}

Cylinder::Cylinder(const ConstVectorRef& p, const ConstVectorRef& q, double radius)
    : Frustum("cylinder", p, checked_nonnegative("cylinder", "radius", radius), q, radius) {}

}  // namespace raygauge
