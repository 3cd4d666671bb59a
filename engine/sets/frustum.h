// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/axis.h"
#include "engine/sets/convex_set.h"

namespace raygauge {

/// What a truncated cone and a cylinder have in common: the hull of two discs across one axis, seen from
/// their pieces h_i(u) = u·p_i + r_i |u_⊥|. A view: the members are the set's.
struct Frustum {
  const Axis& axis;  ///< from base to top
  const Vector& base;
  double base_radius;
  const Vector& top;
  double top_radius;

  /// See ConvexSet::inner_radius_unchecked.
  double inner_radius(const double* c) const;

  /// Both discs, base first. Their Hessians are r_i/|u_⊥| times the projector across the axis and u.
  template <class Real>
  void support_pieces(const Real* u, BasicSupportPieces<Real>& pieces) const;

  /// The axis direction, of the sign that u points to, if the way from u to v passes it by closely.
  template <class Real>
  bool facet_normal(const Real* u, const Real* v, Real* normal) const;

  /// The point of the disc at that end that is nearest to `target`.
  template <class Real>
  void facet_point(const Real* normal, const Real* target, Real* point) const;
};

}  // namespace raygauge
