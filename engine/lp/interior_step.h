// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/kernels/kernel.h"
#include "engine/lp/interior_sides.h"
#include "engine/lp/shared_gram.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// Of the weights x and of the slacks s.
struct StepLengths {
  double x = 1;
  double s = 1;
};

/// Σ x·s after steps of these lengths.
double complementarity(const InteriorSides& sides, const StepLengths& lengths = {0, 0});

/// A step of InteriorPoint: M dy = b - A S⁻¹ target with M = A X S⁻¹ Aᵀ, the matrix Σ d p pᵀ over all points
/// bordered by the convexity row.
class InteriorStep {
 public:
  void begin(int n, const Kernels& kernels, const InteriorSides& sides);

  /// M of the weights and slacks at hand, factored. Columns that weigh less than a share `negligible` of the
  /// (n + 1)st heaviest are left out. False where M is not positive definite.
  bool factor(InteriorSides& sides, InteriorPasses& passes, double negligible);

  /// Moves x, s and y by predictor and corrector (Mehrotra); where `correct`, by further correctors as long
  /// as they lengthen the step (Gondzio). Returns the shorter of the two lengths.
  double take(InteriorSides& sides, InteriorPasses& passes, double* y, bool correct);

 private:
  void leave_out_negligible(InteriorSides& sides, double negligible, double unit);
  StepLengths choose(InteriorSides& sides, InteriorPasses& passes, bool correct);
  void solve_for(double* rhs);
  void follow_targets(InteriorSides& sides, InteriorPasses& passes);
  void keep(InteriorSides& sides);

  int n_ = 0;
  const Kernels* kernels_ = nullptr;
  SharedGram gram_;               // Σ d p pᵀ, then its factor
  AlignedBuffer<double> border_;  // Σ d_A a, and M⁻¹ of it
  double pivot_ = 0;              // of the convexity row
  AlignedBuffer<double> ranked_;  // weights, to find the (n + 1)st
  AlignedBuffer<double> dy_;
  AlignedBuffer<double> kept_dy_;
};

}  // namespace raygauge
