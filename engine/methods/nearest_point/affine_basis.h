// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// Points p_i of R^n, each of one of one or two sides t_i, and the least-squares problem over their affine
/// hulls
///
///     minimize |Σ x_i p_i|   subject to   Σ_{t_i = t} x_i = 1 for every side t,
///
/// by the factors of  (p_i; σ e_{t_i}) = Q R,  Q orthonormal, R upper triangular. With the last rows Q_l of Q
/// the solution is R x = Q_lᵀ ν,  Q_l Q_lᵀ ν = σ 1. Adding a point costs O(n k), removing one O(n k) by
/// rotations.
class AffineBasis {
 public:
  /// Forgets all points. `sigma` > 0: the magnitude of the points.
  void begin(int n, int sides, double sigma, const Kernels& kernels);

  /// False, and nothing is changed, where the point lies in the affine hull of the others up to rounding.
  bool add(const double* point, int side);
  void remove(int i);

  int count() const noexcept { return count_; }
  int side(int i) const noexcept { return side_[static_cast<std::size_t>(i)]; }

  /// Writes the weights x and v = Σ x_i p_i. False where the factors have lost their meaning.
  bool solve(double* weights, double* v);

 private:
  double* column(int i) noexcept { return Q_.data() + i * ld_; }
  double* row(int i) noexcept { return R_.data() + i * row_ld_; }
  void add_to_sums(int i, double sign);
  bool solve_multipliers(double* multipliers) const;

  int n_ = 0;
  int sides_ = 1;
  int count_ = 0;
  int capacity_ = 0;
  double sigma_ = 1;
  std::ptrdiff_t ld_ = 0;      // of Q
  std::ptrdiff_t row_ld_ = 0;  // of R
  const Kernels* kernels_ = nullptr;
  AlignedBuffer<double> Q_, R_, coefficients_, x_;
  AlignedBuffer<double> sums_;  // Q Q_lᵀ: a padded column for each side
  AlignedBuffer<int> side_;
};

}  // namespace raygauge
