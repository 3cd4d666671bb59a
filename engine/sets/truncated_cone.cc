// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/truncated_cone.h"

#include "engine/sets/parameters.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {

TruncatedCone::TruncatedCone(const ConstVectorRef& base, double base_radius, const ConstVectorRef& top,
                             double top_radius)
    : ConvexSet(static_cast<int>(base.size())),
      axis_("truncated cone", base, top),
      base_(base),
      top_(top),
      base_radius_(checked_nonnegative("truncated cone", "base_radius", base_radius)),
      top_radius_(checked_nonnegative("truncated cone", "top_radius", top_radius)) {}

double TruncatedCone::do_support(const double* u, double* point) const {
  const int n = dimension();
  const double across = axis_.radial_part(u, point);
  const double base_value = dot(u, base_.data(), n) + base_radius_ * across;
  const double top_value = dot(u, top_.data(), n) + top_radius_ * across;
  const bool at_top = top_value > base_value;
  const Vector& disc = at_top ? top_ : base_;
  const double radius = at_top ? top_radius_ : base_radius_;
  for (int k = 0; k < n; ++k) point[k] = disc[k] + radius * point[k];
  return at_top ? top_value : base_value;
}

void TruncatedCone::do_center(double* point) const {
  Vector::Map(point, dimension()) = 0.5 * base_ + 0.5 * top_;
}

void TruncatedCone::do_magnitude(double* magnitude) const {
  const Vector& a = axis_.direction();
  const double share = 4 * a.lpNorm<1>();  // of the axis in the rounding errors of u_⊥
  Vector::Map(magnitude, dimension()) = base_.cwiseAbs().cwiseMax(top_.cwiseAbs()).array() +
                                        std::max(base_radius_, top_radius_) * (2 + share * a.array().abs());
}

double TruncatedCone::do_inner_radius(const double* c) const { return frustum().inner_radius(c); }

SupportStructure TruncatedCone::do_structure() const noexcept { return SupportStructure::smooth; }

void TruncatedCone::do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const {
  if (capacity >= 2) frustum().support_pieces(u, pieces);
}

bool TruncatedCone::do_facet_normal(const double* u, const double* v, double* normal) const {
  return frustum().facet_normal(u, v, normal);
}

void TruncatedCone::do_facet_point(const double* normal, const double* target, double* point) const {
  frustum().facet_point(normal, target, point);
}

void TruncatedCone::do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const {
  if (capacity >= 2) frustum().support_pieces(u, pieces);
}

bool TruncatedCone::do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const {
  return frustum().facet_normal(u, v, normal);
}

void TruncatedCone::do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const {
  frustum().facet_point(normal, target, point);
}

}  // namespace raygauge
