// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {x : l_k <= x_k <= r_k for all k}, a box along the axes; l_k = r_k is allowed.
///
///     h(u) = Σ_k max(u_k l_k, u_k r_k),      s(u)_k = r_k where u_k > 0, else l_k.
class Box final : public ConvexSet {
 public:
  /// From the lower corner l and the upper corner r. Throws InvalidParameterError (n < 1, l_k > r_k),
  /// DimensionMismatchError or NonFiniteError.
  Box(const ConstVectorRef& lower, const ConstVectorRef& upper);

  const Vector& lower() const noexcept { return lower_; }
  const Vector& upper() const noexcept { return upper_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;

  Vector lower_;
  Vector upper_;
};

}  // namespace raygauge
