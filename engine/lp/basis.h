// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/threads/helpers.h"

namespace raygauge {

/// Proven statement about the basic solution x* = B⁻¹ b in exact arithmetic: |x*_i - x_i| <= error for every
/// i.
struct Enclosure {
  bool valid = false;  ///< B is proven regular
  double error = 0;
};

/// Owner of a simplex basis (see BasisView) and of the operations that are not on the hot path. b is the
/// right-hand side.
class Basis {
 public:
  /// Prepares an empty basis of m columns; everything is zero afterwards. Allocates only when m grows.
  void reset(int m, const Kernels& kernels);

  /// Threads that share an inversion and a proof of it; their number does not change a bit.
  void share_with(const Helpers& helpers) noexcept { helpers_ = helpers; }

  /// Puts `column` (m entries) at position i without touching the inverse; call refactor() when all are set.
  void set_column(int i, const double* column, double cost, std::int64_t id);

  /// R = B⁻¹ afresh by Gauss–Jordan with partial pivoting, then x and y. False if B is numerically singular;
  /// R is then unusable.
  bool refactor();

  /// yᵀ = c_Bᵀ R, corrected once by the residual c_B - Bᵀ y; the objective too.
  void refresh_duals();

  /// |b - B x|∞ as computed: how far the updates of x have drifted.
  double drift() const;

  /// A proven enclosure of B⁻¹ b around x by Rump's theorem: with E = I - R B and ‖E‖∞ < 1,
  /// |x* - x|∞ <= ‖R (b - B x)‖∞ / (1 - ‖E‖∞), every rounding error bounded. With `refine`, x takes a step of
  /// iterative refinement first.
  Enclosure enclose(bool refine);

  /// ‖I - R B‖∞, every rounding error in it bounded. Below 1, B is proven regular. Computed once for an
  /// inverse.
  double residual_share() { return norms().residual; }

  /// ‖R‖∞ as computed, at the price of residual_share().
  double norm_of_inverse() { return norms().R; }

  BasisView& view() noexcept { return view_; }
  const BasisView& view() const noexcept { return view_; }
  double* right_hand_side() noexcept { return b_.data(); }
  const double* right_hand_side() const noexcept { return b_.data(); }
  const double* column(int i) const noexcept { return view_.B + static_cast<std::ptrdiff_t>(i) * view_.P; }

 private:
  bool invert();
  bool invert_together(double* M, int* exchanged) const;  // with helpers, of many columns
  const MatrixNorms& norms();
  MatrixNorms norms_together();

  BasisView view_;
  const Kernels* kernels_ = nullptr;
  Helpers helpers_;
  AlignedBuffer<double> memory_;
  AlignedBuffer<std::int64_t> ids_;
  AlignedBuffer<double> b_;
  AlignedBuffer<double> factor_;
  AlignedBuffer<int> exchanged_;
  MatrixNorms norms_;               // norms(),
  std::int64_t norms_pivots_ = -1;  // after so many basis changes; -1: of no inverse
};

}  // namespace raygauge
