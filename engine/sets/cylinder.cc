// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/cylinder.h"

#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

Cylinder::Cylinder(const ConstVectorRef& p, const ConstVectorRef& q, double radius)
    : ConvexSet(static_cast<int>(p.size())),
      axis_("cylinder", p, q),
      p_(p),
      q_(q),
      radius_(checked_nonnegative("cylinder", "radius", radius)) {}

double Cylinder::do_support(const double* u, double* point) const {
  const int n = dimension();
  const double along_p = dot(u, p_.data(), n);
  const double along_q = dot(u, q_.data(), n);
  const Vector& end = along_q > along_p ? q_ : p_;
  const double across = axis_.radial_part(u, point);
  for (int k = 0; k < n; ++k) point[k] = end[k] + radius_ * point[k];
  return std::max(along_p, along_q) + radius_ * across;
}

void Cylinder::do_center(double* point) const { Vector::Map(point, dimension()) = 0.5 * p_ + 0.5 * q_; }

void Cylinder::do_magnitude(double* magnitude) const {
  const Vector& a = axis_.direction();
  const double share = 4 * a.lpNorm<1>();  // of the axis in the rounding errors of u_⊥
  Vector::Map(magnitude, dimension()) =
      p_.cwiseAbs().cwiseMax(q_.cwiseAbs()).array() + radius_ * (2 + share * a.array().abs());
}

double Cylinder::do_inner_radius(const double* c) const { return frustum().inner_radius(c); }

SupportStructure Cylinder::do_structure() const noexcept { return SupportStructure::smooth; }

void Cylinder::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  if (capacity >= 2) frustum().support_pieces(u, pieces);
}

bool Cylinder::do_facet_normal(const double* u, const double* v, double* normal) const {
  return frustum().facet_normal(u, v, normal);
}

void Cylinder::do_facet_point(const double* normal, const double* target, double* point) const {
  frustum().facet_point(normal, target, point);
}

void Cylinder::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  if (capacity >= 2) frustum().support_pieces(u, pieces);
}

bool Cylinder::do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const {
  return frustum().facet_normal(u, v, normal);
}

void Cylinder::do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const {
  frustum().facet_point(normal, target, point);
}

}  // namespace raygauge
