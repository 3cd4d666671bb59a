// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/gauge_bound.h"
#include "engine/lp/refined_basis.h"
#include "engine/methods/column_generation/answer.h"

namespace raygauge {

/// Bounds from solution and duals of the basis at hand to some 30 digits.
class RefinedProof {
 public:
  void begin() noexcept { gauge_per_residual_ = 0; }

  /// The lower bound. Columns whose reduced costs only those digits tell from zero are brought in. +infinity
  /// where there is no inverse to refine with.
  double lower(const SiftingSolve& solve);
  double upper(const SiftingSolve& solve);

  /// An upper bound in doubles. At a degenerate optimum some weights are zero and cannot be proven
  /// nonnegative; and where a limit ended the solve artificial columns may still carry weight. What they
  /// leave of the equations is paid for.
  double upper_despite_residual(const SiftingSolve& solve);

 private:
  bool enter(const SiftingSolve& solve, std::int64_t best_A, std::int64_t best_Q);
  double gauge_per_residual(const SiftingSolve& solve);

  RefinedBasis refined_;
  GaugeBound gauge_bound_;
  double gauge_per_residual_ = 0;  // of gauge_bound_; 0: not computed
};

}  // namespace raygauge
