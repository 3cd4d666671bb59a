// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/axis.h"
#include "engine/sets/convex_set.h"
#include "engine/sets/frustum.h"

namespace raygauge {

/// {x : 0 <= (x - p)·a <= |q - p|, |(x - p)_⊥| <= r}, the cylinder around the segment from p to q, a = (q -
/// p)/|q - p|; in R^n its cross-section is a ball of n - 1 dimensions. r = 0 is a segment.
///
///     h(u) = max(u·p, u·q) + r |u_⊥|,      s(u) = (q where u·(q - p) > 0, else p) + r u_⊥/|u_⊥|,
///     u_⊥ = u - (u·a) a.
class Cylinder final : public ConvexSet {
 public:
  /// Throws InvalidParameterError (n < 1, p = q, r < 0), DimensionMismatchError or NonFiniteError.
  Cylinder(const ConstVectorRef& p, const ConstVectorRef& q, double radius);

  const Vector& p() const noexcept { return p_; }
  const Vector& q() const noexcept { return q_; }
  double radius() const noexcept { return radius_; }

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

  Frustum frustum() const noexcept { return {axis_, p_, radius_, q_, radius_}; }

  Axis axis_;
  Vector p_;
  Vector q_;
  double radius_;
};

}  // namespace raygauge
