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
  void support_pieces(const double* u, SupportPieces& pieces) const;

  /// The axis direction, of the sign that u points to, if the way from u to v passes it by closely.
  bool facet_normal(const double* u, const double* v, double* normal) const;

  /// The point of the disc at that end that is nearest to `target`.
  void facet_point(const double* normal, const double* target, double* point) const;
};

}  // namespace raygauge
