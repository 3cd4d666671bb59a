// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

class Axis;

/// The hull of two discs across one axis, in R^n balls of n - 1 dimensions: what a truncated cone and a
/// cylinder are, by the names of their own parameters. Its support function has a piece for each disc,
///
///     h(u) = max_i (u·p_i + r_i |u_⊥|),      s(u) = p_i + r_i u_⊥/|u_⊥|,      u_⊥ = u - (u·a) a,
///
/// with the Hessian r_i/|u_⊥| times the projector across the axis and u; the discs are its flat faces.
class Frustum : public ConvexSet, private SmoothSupport, private FlatFaces {
 public:
  const Vector& base() const noexcept { return base_; }
  const Vector& top() const noexcept { return top_; }
  double base_radius() const noexcept { return base_radius_; }
  double top_radius() const noexcept { return top_radius_; }

 protected:
  /// `set` is its name in messages. The radii are the caller's to check.
  Frustum(const std::string& set, const ConstVectorRef& base, double base_radius, const ConstVectorRef& top,
          double top_radius);

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override { return this; }
  const FlatFaces* do_flat_faces() const noexcept override { return this; }
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  bool do_facet_normal(const double* u, const double* v, double* normal) const override;
  void do_facet_point(const double* normal, const double* target, double* point) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const override;
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const override;

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;
  template <class Real>
  bool find_facet_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void find_facet_point(const Real* normal, const Real* target, Real* point) const;

  std::shared_ptr<const Axis> axis_;  // from base to top
  Vector base_;
  Vector top_;
  double base_radius_;
  double top_radius_;
};

/// conv(D_b ∪ D_t), D_i = {x : |x - p_i| <= r_i, (x - p_i)·a = 0}: the truncated cone between two discs
/// across the axis a = (p_t - p_b)/|p_t - p_b|; in R^n the discs are balls of n - 1 dimensions. r_t = 0 is a
/// cone, r_t = r_b a cylinder, r_t > r_b an inverted cone, both 0 a segment.
///
///     h(u) = max_i (u·p_i + r_i |u_⊥|),      s(u) = p_i + r_i u_⊥/|u_⊥|,      u_⊥ = u - (u·a) a.
class TruncatedCone final : public Frustum {
 public:
  /// Throws InvalidParameterError (n < 1, p_b = p_t, a negative radius), DimensionMismatchError or
  /// NonFiniteError.
  TruncatedCone(const ConstVectorRef& base, double base_radius, const ConstVectorRef& top, double top_radius);
};

/// {x : 0 <= (x - p)·a <= |q - p|, |(x - p)_⊥| <= r}, the cylinder around the segment from p to q, a = (q -
/// p)/|q - p|; in R^n its cross-section is a ball of n - 1 dimensions. r = 0 is a segment.
///
///     h(u) = max(u·p, u·q) + r |u_⊥|,      s(u) = (q where u·(q - p) > 0, else p) + r u_⊥/|u_⊥|,
///     u_⊥ = u - (u·a) a.
class Cylinder final : public Frustum {
 public:
  /// Throws InvalidParameterError (n < 1, p = q, r < 0), DimensionMismatchError or NonFiniteError.
  Cylinder(const ConstVectorRef& p, const ConstVectorRef& q, double radius);

  const Vector& p() const noexcept { return base(); }
  const Vector& q() const noexcept { return top(); }
  double radius() const noexcept { return base_radius(); }
};

}  // namespace raygauge
