// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/kernels/kernel.h"
#include "engine/lp/basis.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// The basic solution and the duals of a basis to some 30 digits, by iterative refinement with the inverse in
/// doubles and residuals as if in 106 bits: O(m²) where the inverse is at hand. What it proves is proven as
/// Basis::enclose() proves it, with an error that is some 10⁻¹⁶ of that.
class RefinedBasis {
 public:
  /// Refines the duals y of `basis` to y + dual_low().
  void refine_duals(Basis& basis, const Kernels& kernels);
  const double* dual_low() const noexcept { return y_low_.data(); }  ///< padded_rows(m) doubles

  /// Σ of the costs of the exact basic solution, rounded up, where that solution is proven positive and
  /// holds no artificial column; +infinity otherwise. Costs are 0 and 1.
  double upper(Basis& basis, const Kernels& kernels);

  /// After upper(): for a solution with zeros in it, which rounding makes negative. These are left out, and
  /// so are artificial columns; with G of GaugeBound,  d <= (Σβ + G |r|∞) / Σα,  r the residual. +infinity
  /// where a weight is negative by more than rounding.
  double upper_with_residual(Basis& basis, const Kernels& kernels, double gauge_bound);

 private:
  void refine_solution(Basis& basis, const Kernels& kernels);

  AlignedBuffer<double> x_low_;
  AlignedBuffer<double> y_low_;
};

}  // namespace raygauge
