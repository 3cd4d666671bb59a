// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {x : the distance of x to the segment from p to q is <= r}, a segment thickened by a ball, in any R^n. p =
/// q is a ball, r = 0 a segment.
///
///     h(u) = max(u·p, u·q) + r|u|,      s(u) = (q where u·(q - p) > 0, else p) + r u/|u|.
class Capsule final : public ConvexSet, private SmoothSupport {
 public:
  /// Throws InvalidParameterError (n < 1, r < 0), DimensionMismatchError or NonFiniteError.
  Capsule(const ConstVectorRef& p, const ConstVectorRef& q, double radius);

  const Vector& p() const noexcept { return p_; }
  const Vector& q() const noexcept { return q_; }
  double radius() const noexcept { return radius_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;
  const SmoothSupport* do_smooth() const noexcept override { return this; }
  void do_support_pieces(const double* u, SupportPieces& pieces, int capacity) const override;
  void do_quad_pieces(const Quad* u, QuadSupportPieces& pieces, int capacity) const override;

  template <class Real>
  void list_pieces(const Real* u, BasicSupportPieces<Real>& pieces, int capacity) const;

  Vector p_;
  Vector q_;
  double radius_;
};

}  // namespace raygauge
