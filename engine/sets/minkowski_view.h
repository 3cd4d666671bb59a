// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/combined_view.h"

namespace raygauge {

/// A point as an unevaluated sum high + low, n doubles each: the centre of a posed set has no doubles of its
/// own. Without `low` it is high; without either it is the origin.
struct TwofoldPoint {
  const double* high = nullptr;
  const double* low = nullptr;
};

/// S + sign T + a - b, with `sign` 1 or -1. All must outlive their use.
struct ShiftedSum {
  const ConvexSet* S = nullptr;
  const ConvexSet* T = nullptr;
  double sign = 1;
  TwofoldPoint a = {}, b = {};
  bool keeps_parts = false;  ///< parts of points are asked for: then no method may move points along faces
};

/// S + T or S - T, moved by a - b for two points a and b: what sums, differences, pairs of objects and the
/// body of the growth distance have in common. It refers to its operands.
///
///     h(u) = h_S(u) + h_T(±u) + u·(a - b),      s(u) = s_S(u) ± s_T(±u) + a - b.
///
/// What the operands offer beyond their support functions is kept: pieces where both have them, the flat
/// faces of either, symmetry about the axes where both have it, and gauges. A gauge that both operands have
/// gives the bound 1/(1/g_S + 1/g_T); a set and {0} has the set's own.
class MinkowskiView : public CombinedView<MinkowskiView> {
 public:
  explicit MinkowskiView(const ShiftedSum& sum) : CombinedView(sum.S->dimension()), sum_(sum) {}

  const ShiftedSum& sum() const noexcept { return sum_; }

  /// s(u) with its part s_T(±u), and h(u).
  double support_with_part(const double* u, double* point, double* of_T) const;

  /// The pieces with the points of T in them, which `of_T` has room for (kCapacity points, or null): that of
  /// piece i is number i % count, where `count` is returned.
  template <class Real>
  int pieces_with_parts(const Real* u, BasicSupportPieces<Real>& pieces, int capacity, Real* of_T) const;

  /// FlatFaces::point with its part in T; false where there is none.
  template <class Real>
  bool facet_point_with_part(const Real* normal, const Real* target, Real* point, Real* of_T) const;

  bool is_smooth() const noexcept { return sum_.S->smooth() != nullptr && sum_.T->smooth() != nullptr; }
  bool has_flat_faces() const noexcept;
  bool has_gauge() const noexcept;
  bool has_symmetry() const noexcept;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const {
    pieces_with_parts<Real>(u, pieces, capacity, nullptr);
  }
  template <class Real>
  bool find_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void find_point(const Real* normal, const Real* target, Real* point) const;

 protected:
  double do_inner_radius(const double* c) const override;

 private:
  double do_support(const double* u, double* point) const final;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const final;
  SupportStructure do_structure() const noexcept final {
    return structure_of_sum(sum_.S->structure(), sum_.T->structure());
  }
  double do_gauge(const double* x, double* normal) const final;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const final;
  bool do_touches_origin(double* u) const final;
  bool do_is_unconditional(double* extent) const final;
  bool do_summands(const double* u, double* reach, double* change) const final;

  ShiftedSum sum_;
};

}  // namespace raygauge
