// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/double_double.h"

namespace raygauge {

/// A simplex basis B of m columns of doubles with its explicit inverse R in double-double arithmetic, for
/// bases whose condition (to 10²⁶ or so) leaves nothing of an inverse in doubles. The right-hand side is the
/// last unit vector, so that the basic solution x = B⁻¹ b is R's last column. Positions without a column of
/// the caller's hold artificial ones ±e_i.
class TwofoldBasis {
 public:
  static constexpr std::int64_t kArtificial = -1;

  /// B = R = I, all columns artificial.
  void reset(int m, const Kernels& kernels);

  /// w = R column (m doubles).
  void transform(const double* column);
  DoubleDouble w(int i) const { return {w_[at(i)], w_low_[at(i)]}; }

  /// The transformed column takes position r, at which w is not zero.
  void replace(int r, const double* column, std::int64_t id);

  /// R afresh from the columns, which may change places; artificial ones ±e_i keep theirs. Columns that
  /// depend on others give way to such. Then a step R += (I - R B) R (Schulz): elimination leaves errors in
  /// the small entries of R c.
  void refactor();

  /// As part of that: the column takes the position of an artificial column where it has its largest entry.
  /// False where that is rounding.
  bool place(const double* column, std::int64_t id);

  /// The column at position i changes sign and counts as artificial.
  void make_artificial(int i);

  DoubleDouble R(int i, int k) const { return {R_[entry(i, k)], R_low_[entry(i, k)]}; }
  DoubleDouble x(int i) const { return R(i, m_ - 1); }
  const double* column(int i) const { return B_.data() + entry(0, i); }
  std::int64_t id(int i) const { return id_[at(i)]; }
  bool is_artificial(int i) const { return id(i) < 0; }
  int size() const noexcept { return m_; }

  /// ‖R‖∞, rounded up.
  double norm() const;

  /// Σ_k |R_ik| for every row i, in about.
  void norms_of_rows(double* norm) const;

  /// An upper bound on ‖I - R B‖∞; B is proven regular where it is below 1.
  double residual_share();

  /// The basic solution as Σ_c x^c of three doubles each, refined with residuals b - B x free of rounding,
  /// and a bound on |x*_i - Σ_c x^c_i|; +infinity where nothing is proven. O(m²) after residual_share().
  struct Solution {
    std::array<AlignedBuffer<double>, 3> part;
    double error = 0;
  };
  void solve(Solution& x);

  /// Refines duals y (m doubles) to y + y_low by c_i - B_i · (y + y_low), free of rounding.
  void refine_duals(std::span<const double> cost, double* y, double* y_low);

 private:
  std::size_t at(int i) const { return static_cast<std::size_t>(i); }
  std::size_t entry(int i, int k) const { return at(k) * at(P_) + at(i); }
  void improve();
  bool is_unit(int i) const;
  void set_unit(int i, double sign);
  double residual_of_row(const Solution& x, int k, double* error) const;
  double refine(Solution& x, bool correcting);

  const Kernels* kernels_ = nullptr;
  int m_ = 0;
  int P_ = 0;
  AlignedBuffer<double> R_, R_low_, B_;  // m columns of P_ entries, padding zero
  AlignedBuffer<double> w_, w_low_;
  AlignedBuffer<double> scale_, scale_low_;  // of a change of R; of residuals
  AlignedBuffer<double> rows_;               // Σ_k |R_ik|, and sums like it
  AlignedBuffer<std::int64_t> id_;
  AlignedBuffer<bool> taken_;      // while columns are placed: positions that are not to be had
  AlignedBuffer<double> columns_;  // of before a factorisation; I - R B after it
  AlignedBuffer<std::int64_t> ids_;
};

}  // namespace raygauge
