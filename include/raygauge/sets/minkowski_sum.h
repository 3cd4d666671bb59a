// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// S + T or S - T, moved by a - b for two points a and b: what sums, differences, pairs of objects and the
/// body of the growth distance have in common. It refers to its operands, which its subclass keeps.
///
///     h(u) = h_S(u) + h_T(±u) + u·(a - b),      s(u) = s_S(u) ± s_T(±u) + a - b.
///
/// What the operands offer beyond their support functions is kept: pieces where both have them, the flat
/// faces of either, symmetry about the axes where both have it, and gauges. A gauge that both operands have
/// gives the bound 1/(1/g_S + 1/g_T); a set and {0} has the set's own.
class MinkowskiView : public ConvexSet,
                      private SmoothSupport,
                      private FlatFaces,
                      private GaugeFormula,
                      private CoordinateSymmetry {
 protected:
  explicit MinkowskiView(int dimension) : ConvexSet(dimension) {}

  /// A point as an unevaluated sum high + low, n doubles each: the centre of a posed set has no doubles of
  /// its own. Without `low` it is high; without either it is the origin.
  struct TwofoldPoint {
    const double* high = nullptr;
    const double* low = nullptr;
  };

  /// The operands, and `sign` 1 or -1. All must outlive their use; a and b may both be the origin.
  void look_at(const ConvexSet& S, const ConvexSet& T, double sign) noexcept { look_at(S, T, sign, {}, {}); }
  void look_at(const ConvexSet& S, const ConvexSet& T, double sign, const TwofoldPoint& a,
               const TwofoldPoint& b) noexcept {
    S_ = &S;
    T_ = &T;
    sign_ = sign;
    a_ = a.high;
    b_ = b.high;
    a_low_ = a.low;
    b_low_ = b.low;
  }

  double do_inner_radius(const double* c) const override;

  /// s(u) with its part s_T(±u), and h(u).
  double support_with_part(const double* u, double* point, double* of_T) const;

  /// The pieces with the points of T in them, which `of_T` has room for (kCapacity points, or null): that of
  /// piece i is number i % count, where `count` is returned.
  template <class Real>
  int pieces_with_parts(const Real* u, BasicSupportPieces<Real>& pieces, int capacity, Real* of_T) const;

  /// FlatFaces::point with its part in T; false where there is none.
  template <class Real>
  bool facet_point_with_part(const Real* normal, const Real* target, Real* point, Real* of_T) const;

  const ConvexSet& first() const noexcept { return *S_; }
  const ConvexSet& second() const noexcept { return *T_; }

 private:
  /// Whether the parts of a point are asked for. Then no method may move points along faces.
  virtual bool keeps_parts() const noexcept { return false; }

  double do_support(const double* u, double* point) const final;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const final;
  SupportStructure do_structure() const noexcept final {
    return structure_of_sum(S_->structure(), T_->structure());
  }
  const SmoothSupport* do_smooth() const noexcept final;
  const FlatFaces* do_flat_faces() const noexcept final;
  const GaugeFormula* do_gauge_formula() const noexcept final;
  const CoordinateSymmetry* do_symmetry() const noexcept final;

  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const final;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const final;
  bool do_facet_normal(const double* u, const double* v, double* normal) const final;
  void do_facet_point(const double* normal, const double* target, double* point) const final;
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const final;
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const final;
  double do_gauge(const double* x, double* normal) const final;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const final;
  bool do_touches_origin(double* u) const final;
  bool do_is_unconditional(double* extent) const final;
  bool do_summands(const double* u, double* reach, double* change) const final;

  template <class Real>
  bool find_facet_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void add_normals(Real* normal, Real* of_T) const;
  template <class Ask, class Real>
  auto ask_second(const Ask& ask, const Real* x, Real* normal) const;
  template <class Real = double>
  Real shift(int k) const noexcept {
    if (a_ == nullptr) return Real{0};
    const Real low_a = a_low_ != nullptr ? a_low_[k] : 0.0, low_b = b_low_ != nullptr ? b_low_[k] : 0.0;
    return (Real{a_[k]} - b_[k]) + (low_a - low_b);
  }
  bool is_shifted() const noexcept;
  bool is_shifted_by_doubles() const noexcept;
  bool is_first_alone() const;
  bool is_second_alone() const;

  const ConvexSet* S_ = nullptr;
  const ConvexSet* T_ = nullptr;
  double sign_ = 1;
  const double* a_ = nullptr;
  const double* b_ = nullptr;
  const double* a_low_ = nullptr;
  const double* b_low_ = nullptr;
};

/// A + B = {a + b : a in A, b in B}.
///
///     h(u) = h_A(u) + h_B(u),      s(u) = s_A(u) + s_B(u),      centre c_A + c_B.
class MinkowskiSum final : public MinkowskiView {
 public:
  /// Throws InvalidParameterError (null pointer) or DimensionMismatchError.
  MinkowskiSum(std::shared_ptr<const ConvexSet> A, std::shared_ptr<const ConvexSet> B);

  const std::shared_ptr<const ConvexSet>& A() const noexcept { return A_; }
  const std::shared_ptr<const ConvexSet>& B() const noexcept { return B_; }

 private:
  std::shared_ptr<const ConvexSet> A_;
  std::shared_ptr<const ConvexSet> B_;
};

/// A2 - A1 = A2 + (-A1) = {a2 - a1 : a2 in A2, a1 in A1}: d_Q of it is the distance from object A1 to object
/// A2 in the gauge of Q, and it contains the origin where the two meet.
///
///     h(u) = h_A2(u) + h_A1(-u),      s(u) = s_A2(u) - s_A1(-u),      centre c_A2 - c_A1.
class MinkowskiDifference final : public MinkowskiView {
 public:
  /// Throws InvalidParameterError (null pointer) or DimensionMismatchError.
  MinkowskiDifference(std::shared_ptr<const ConvexSet> A2, std::shared_ptr<const ConvexSet> A1);

  const std::shared_ptr<const ConvexSet>& A2() const noexcept { return A2_; }
  const std::shared_ptr<const ConvexSet>& A1() const noexcept { return A1_; }

 private:
  std::shared_ptr<const ConvexSet> A2_;
  std::shared_ptr<const ConvexSet> A1_;
};

}  // namespace raygauge
