// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {x : |x - c| <= r}, the Euclidean ball of R^n; r = 0 is the point c.
///
///     h(u) = u·c + r|u|,      s(u) = c + r u/|u|  (c for u = 0).
class Ball final : public ConvexSet, private SmoothSupport, private GaugeFormula {
 public:
  /// Throws InvalidParameterError (n < 1, r < 0) or NonFiniteError.
  Ball(const ConstVectorRef& center, double radius);

  double radius() const noexcept { return radius_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const override;
  bool do_touches_origin(double* u) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override { return this; }
  const GaugeFormula* do_gauge_formula() const noexcept override { return this; }
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  Vector center_;
  double radius_;
};

}  // namespace raygauge
