// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/axis.h"
#include "engine/sets/convex_set.h"
#include "engine/sets/frustum.h"

namespace raygauge {

/// conv(D_b ∪ D_t), D_i = {x : |x - p_i| <= r_i, (x - p_i)·a = 0}: the truncated cone between two discs
/// across the axis a = (p_t - p_b)/|p_t - p_b|; in R^n the discs are balls of n - 1 dimensions. r_t = 0 is a
/// cone, r_t = r_b a cylinder, r_t > r_b an inverted cone, both 0 a segment.
///
///     h(u) = max_i (u·p_i + r_i |u_⊥|),      s(u) = p_i + r_i u_⊥/|u_⊥|,      u_⊥ = u - (u·a) a.
class TruncatedCone final : public ConvexSet {
 public:
  /// Throws InvalidParameterError (n < 1, p_b = p_t, a negative radius), DimensionMismatchError or
  /// NonFiniteError.
  TruncatedCone(const ConstVectorRef& base, double base_radius, const ConstVectorRef& top, double top_radius);

  const Vector& base() const noexcept { return base_; }
  const Vector& top() const noexcept { return top_; }
  double base_radius() const noexcept { return base_radius_; }
  double top_radius() const noexcept { return top_radius_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  bool do_facet_normal(const double* u, const double* v, double* normal) const override;
  void do_facet_point(const double* normal, const double* target, double* point) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const override;
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const override;

  Frustum frustum() const noexcept { return {axis_, base_, base_radius_, top_, top_radius_}; }

  Axis axis_;
  Vector base_;
  Vector top_;
  double base_radius_;
  double top_radius_;
};

}  // namespace raygauge
