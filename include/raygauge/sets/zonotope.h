// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {c + Σ_i t_i g_i : |t_i| <= 1}, the zonotope with centre c and generators g_i: the Minkowski sum of the
/// segments [-g_i, g_i], about c.
///
///     h(u) = u·c + Σ_i |u·g_i|,      s(u) = c + Σ_i sign(u·g_i) g_i  (+ for 0).
///
/// Generators may be dependent, zero, or none: it is flat then, or the point c.
class Zonotope final : public ConvexSet {
 public:
  /// `generators` is n × m, one a column. Throws InvalidParameterError (n < 1), DimensionMismatchError or
  /// NonFiniteError.
  Zonotope(const ConstVectorRef& center, const Eigen::Ref<const Eigen::MatrixXd>& generators);

  const DenseMatrix& generators() const noexcept { return generators_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override { return SupportStructure::polytope; }

  Vector center_;
  DenseMatrix generators_;
  Vector magnitude_;
  double radius_ = 0;  // of a ball about c inside
};

}  // namespace raygauge
