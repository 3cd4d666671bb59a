// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {c + diag(w) z : ‖z‖_p <= 1}, the ball of a weighted p-norm with semi-axes w_k >= 0 along the axes, 1 <= p
/// <= infinity. With v = diag(w) u and the conjugate exponent q = p/(p - 1):
///
///     h(u) = u·c + ‖v‖_q,      s(u) = c + diag(w) z,      z_k = sign(v_k) (|v_k|/‖v‖_q)^(q-1);
///
/// p = 1: z = sign(v_k) e_k for the smallest k with |v_k| = ‖v‖_∞; p = infinity: z_k = sign(v_k); u = 0: z =
/// 0. Powers are taken of t_k = |v_k| / max|v| <= 1, which cannot overflow for any p.
class PNormBall final : public ConvexSet,
                        private SmoothSupport,
                        private GaugeFormula,
                        private CoordinateSymmetry {
 public:
  /// Throws InvalidParameterError (n < 1, p < 1, w_k < 0), DimensionMismatchError or NonFiniteError (p may be
  /// infinite but not NaN).
  PNormBall(const ConstVectorRef& center, const ConstVectorRef& semi_axes, double p);

  const Vector& semi_axes() const noexcept { return semi_axes_; }
  double p() const noexcept { return p_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  double do_gauge(const double* x, double* normal) const override;
  bool do_quad_gauge_normal(const Quad* x, Quad* normal) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override { return is_smooth() ? this : nullptr; }
  const GaugeFormula* do_gauge_formula() const noexcept override { return has_gauge() ? this : nullptr; }
  const CoordinateSymmetry* do_symmetry() const noexcept override { return is_smooth() ? this : nullptr; }
  bool do_is_unconditional(double* extent) const override;
  bool do_summands(const double* u, double* reach, double* change) const override;
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  bool is_smooth() const noexcept;
  bool has_gauge() const noexcept;
  template <class Real>
  Real norm(const Real* x, Real* normal) const;
  template <class Real>
  Real support(const Real* u, Real* point) const;
  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  Vector center_;
  Vector semi_axes_;
  double p_;
};

}  // namespace raygauge
