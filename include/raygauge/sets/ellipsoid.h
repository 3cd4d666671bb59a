// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

class BoundedInverse;

/// {c + L z : |z| <= 1}, an ellipsoid of any orientation, kept as its factor L (n × m). The shape matrix L Lᵀ
/// is never formed: it would square the ratio of the axes. Semi-axes a along the columns of a rotation R are
/// L = R diag(a); a factor of rank below n is a flat ellipsoid.
///
///     h(u) = u·c + |Lᵀu|,      s(u) = c + L z/|z|, z = Lᵀu  (c for z = 0).
class Ellipsoid final : public ConvexSet, private SmoothSupport, private GaugeFormula {
 public:
  /// Throws InvalidParameterError (n < 1, m < 1), DimensionMismatchError (L does not have n rows) or
  /// NonFiniteError.
  Ellipsoid(const ConstVectorRef& center, const Eigen::Ref<const Eigen::MatrixXd>& factor);

  const DenseMatrix& factor() const noexcept { return factor_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override { return this; }
  const GaugeFormula* do_gauge_formula() const noexcept override;
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  template <class Real>
  Real support(const Real* u, Real* point) const;
  template <class Real>
  Real shape(int j, int k) const;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  Vector center_;
  DenseMatrix factor_;
  DenseMatrix shape_;  // L Lᵀ in double precision, for Hessians alone: no bound depends on it
  std::shared_ptr<const BoundedInverse> inverse_;  // of L, which proves something where L is square
};

}  // namespace raygauge
