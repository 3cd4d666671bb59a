// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/bounded_inverse.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {M x + t : x in S}, the image of S under an invertible affine map of R^n.
///
///     h(u) = h_S(Mᵀu) + u·t,      s(u) = M s_S(Mᵀu) + t,      centre M c_S + t.
class AffineImage final : public ConvexSet {
 public:
  /// M is n × n. Throws InvalidParameterError (null pointer, or M singular: after its rows and columns are
  /// scaled, a pivot of its LU factors is below n ε of the largest), DimensionMismatchError or
  /// NonFiniteError.
  AffineImage(std::shared_ptr<const ConvexSet> S, const Eigen::Ref<const Eigen::MatrixXd>& M,
              const ConstVectorRef& t);

  /// The same for a rigid motion: throws InvalidParameterError also unless RᵀR = 1 to 1e-12 and det R = 1.
  static std::shared_ptr<const AffineImage> rigid(std::shared_ptr<const ConvexSet> S,
                                                  const Eigen::Ref<const Eigen::MatrixXd>& R,
                                                  const ConstVectorRef& t);

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

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;
  template <class Real>
  void map_linearly(const Real* x, int stride, Real* image) const noexcept;
  void map(const double* x, double* image) const noexcept;

  std::shared_ptr<const ConvexSet> S_;
  DenseMatrix M_;
  Vector t_;
  BoundedInverse inverse_;  // of M
};

}  // namespace raygauge
