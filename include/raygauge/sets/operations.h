// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

class BoundedInverse;

/// x ↦ M x + t, M n × n by columns, with what is known of its inverse. All must outlive their use.
struct LinearMap {
  int n = 0;
  const double* M = nullptr;
  const double* t = nullptr;
  const BoundedInverse* inverse = nullptr;  ///< nullptr for a rotation: its inverse is Mᵀ, up to the defect
  double defect = 0;                        ///< of a rotation: at least ‖MᵀM - 1‖ in the spectral norm
  bool exchanges_axes = false;              ///< each row and each column of M has one entry that is not 0
  bool reverses_axes = false;               ///< the same, and these entries are 1 or -1
};

/// {M x + t : x in S}, what AffineImage, sets in poses and placed bodies have in common; it refers to S, M
/// and t, which its subclass keeps.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
///
/// What S offers beyond its support function is kept: pieces and flat faces always, its gauge where t = 0. A
/// proof that it touches the origin, and symmetry about the axes, are kept where M only exchanges, reverses
/// and scales the axes.
class LinearImage : public ConvexSet,
                    private SmoothSupport,
                    private FlatFaces,
                    private GaugeFormula,
                    private CoordinateSymmetry {
 protected:
  explicit LinearImage(int dimension) : ConvexSet(dimension) {}

  /// What this is the image of, and by which map.
  void look_at(const ConvexSet& S, const LinearMap& map) noexcept {
    S_ = &S;
    map_ = map;
  }

 private:
  double do_support(const double* u, double* point) const final;
  void do_center(double* point) const final;
  void do_magnitude(double* magnitude) const final;
  double do_inner_radius(const double* c) const final;
  SupportStructure do_structure() const noexcept final { return S_->structure(); }
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

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;
  template <class Real>
  bool find_facet_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void find_facet_point(const Real* normal, const Real* target, Real* point) const;

  const ConvexSet* S_ = nullptr;
  LinearMap map_;
};

/// {M x + t : x in S}, the image of S under an invertible affine map of R^n. See LinearImage for what it
/// keeps of S.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
class AffineImage final : public LinearImage {
 public:
  /// M is n × n. Throws InvalidParameterError (null pointer, or M singular: after its rows and columns are
  /// scaled, a pivot of its LU factors is below n ε of the largest), DimensionMismatchError or
  /// NonFiniteError.
  AffineImage(std::shared_ptr<const ConvexSet> S, const Eigen::Ref<const Eigen::MatrixXd>& M,
              const ConstVectorRef& t);

  /// The same for a rigid motion: the rotation is that of nearest_rotation(), which may throw.
  static std::shared_ptr<const AffineImage> rigid(std::shared_ptr<const ConvexSet> S,
                                                  const Eigen::Ref<const Eigen::MatrixXd>& R,
                                                  const ConstVectorRef& t);

  const std::shared_ptr<const ConvexSet>& S() const noexcept { return S_; }
  const DenseMatrix& M() const noexcept { return M_; }
  const Vector& t() const noexcept { return t_; }

 private:
  std::shared_ptr<const ConvexSet> S_;
  DenseMatrix M_;
  Vector t_;
  std::shared_ptr<const BoundedInverse> inverse_;  // of M
};

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

  /// What this is from now on.
  void look_at(const ShiftedSum& sum) noexcept { sum_ = sum; }
  const ShiftedSum& sum() const noexcept { return sum_; }

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

 private:
  double do_support(const double* u, double* point) const final;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const final;
  SupportStructure do_structure() const noexcept final {
    return structure_of_sum(sum_.S->structure(), sum_.T->structure());
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

  ShiftedSum sum_;
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

/// conv(S_1 ∪ … ∪ S_m), the convex hull of a union.
///
///     h(u) = max_i h_i(u),      s(u) = s_i(u) for the smallest maximising i,      centre: the mean of the
///     c_i.
class UnionHull final : public ConvexSet,
                        private SmoothSupport,
                        private FlatFaces,
                        private GaugeFormula,
                        private CoordinateSymmetry {
 public:
  /// Throws EmptySetError (m = 0), InvalidParameterError (null pointer) or DimensionMismatchError.
  explicit UnionHull(std::vector<std::shared_ptr<const ConvexSet>> sets);

  const std::vector<std::shared_ptr<const ConvexSet>>& sets() const noexcept { return sets_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override;
  const FlatFaces* do_flat_faces() const noexcept override;
  const GaugeFormula* do_gauge_formula() const noexcept override;
  const CoordinateSymmetry* do_symmetry() const noexcept override;

  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;
  bool do_facet_normal(const double* u, const double* v, double* normal) const override;
  void do_facet_point(const double* normal, const double* target, double* point) const override;
  bool do_quad_facet_normal(const Quad* u, const Quad* v, Quad* normal) const override;
  void do_quad_facet_point(const Quad* normal, const Quad* target, Quad* point) const override;
  double do_gauge(const double* x, double* normal) const override;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const override;
  bool do_touches_origin(double* u) const override;
  bool do_is_unconditional(double* extent) const override;

  template <class Real>
  const ConvexSet& outermost(const Real* u) const;
  template <class Real>
  bool find_facet_normal(const Real* u, const Real* v, Real* normal) const;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  std::vector<std::shared_ptr<const ConvexSet>> sets_;
};

}  // namespace raygauge
