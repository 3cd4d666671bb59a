// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/sets/point_set.h"

namespace raygauge {

/// conv{o, o + a_1 e_1, …, o + a_n e_n}, the simplex with a right-angled corner at o and legs a_k along the
/// axes (a_k of either sign, or 0). With o = 0 and a = 1 it is {x >= 0 : Σx_k <= 1}. Any other simplex is an
/// AffineImage of it, or a PointSet of its vertices.
///
///     h(u) = u·o + max(0, max_k a_k u_k),      s(u) = o + a_k e_k for the smallest maximising k, or o.
class Simplex final : public ConvexSet {
 public:
  /// Throws InvalidParameterError (n < 1), DimensionMismatchError or NonFiniteError.
  Simplex(const ConstVectorRef& corner, const ConstVectorRef& legs);

  const Vector& corner() const noexcept { return corner_; }
  const Vector& legs() const noexcept { return legs_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;

  Vector corner_;
  Vector legs_;
  std::unique_ptr<const PointSet> vertices_;  // for n = 2 and 3, where they are doubles exactly
};

}  // namespace raygauge
