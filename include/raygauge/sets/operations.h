// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

class BoundedInverse;

/// A set that is made of others. What these offer beyond their support functions is kept where it can be
/// (docs/sets.md): a view of them answers.
class CombinedSet : public ConvexSet {
 protected:
  explicit CombinedSet(int dimension) : ConvexSet(dimension) {}

  /// Constructors end with this; the view may refer to members of theirs.
  void set_view(std::unique_ptr<const ConvexSet> view) noexcept { view_ = std::move(view); }

 private:
  double do_support(const double* u, double* point) const final { return view_->support_unchecked(u, point); }
  void do_center(double* point) const final { view_->center_unchecked(point); }
  void do_magnitude(double* magnitude) const final { view_->magnitude_unchecked(magnitude); }
  double do_inner_radius(const double* c) const final { return view_->inner_radius_unchecked(c); }
  SupportStructure do_structure() const noexcept final { return view_->structure(); }
  const SmoothSupport* do_smooth() const noexcept final { return view_->smooth(); }
  const FlatFaces* do_flat_faces() const noexcept final { return view_->flat_faces(); }
  const GaugeFormula* do_gauge_formula() const noexcept final { return view_->gauge(); }
  const CoordinateSymmetry* do_symmetry() const noexcept final { return view_->symmetry(); }

  std::unique_ptr<const ConvexSet> view_;
};

/// {M x + t : x in S}, the image of S under an invertible affine map of R^n.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
class AffineImage final : public CombinedSet {
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

/// A + B = {a + b : a in A, b in B}.
///
///     h(u) = h_A(u) + h_B(u),      s(u) = s_A(u) + s_B(u),      centre c_A + c_B.
class MinkowskiSum final : public CombinedSet {
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
class MinkowskiDifference final : public CombinedSet {
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
class UnionHull final : public CombinedSet {
 public:
  /// Throws EmptySetError (m = 0), InvalidParameterError (null pointer) or DimensionMismatchError.
  explicit UnionHull(std::vector<std::shared_ptr<const ConvexSet>> sets);

  const std::vector<std::shared_ptr<const ConvexSet>>& sets() const noexcept { return sets_; }

 private:
  std::vector<std::shared_ptr<const ConvexSet>> sets_;
};

}  // namespace raygauge
