// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The set of a user's own support mapping: S = conv{s(u) : u in R^n}.
///
///     h(u) = u·s(u),      s(u) as the callable gives it.
class SupportMappingSet final : public ConvexSet {
 public:
  /// Writes s(u), n doubles, to `point`. It must give the same point for the same u, be safe to call from
  /// several threads at once, and accept u = 0; what it throws passes through the solver.
  using Mapping = std::function<void(const double* u, double* point)>;

  /// `center` is a point of S, in its interior if it has one; n is its size. The mapping is tried along ±e_k,
  /// to find gross mistakes early: throws InvalidParameterError (n < 1, empty callable, center beyond a
  /// support plane) or NonFiniteError.
  SupportMappingSet(const ConstVectorRef& center, Mapping mapping);

  const Mapping& mapping() const noexcept { return mapping_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;

  Vector center_;
  Mapping mapping_;
};

}  // namespace raygauge
