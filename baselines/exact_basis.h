// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "baselines/exact_columns.h"

namespace raygauge {

/// A basis B of the linear program of Example 2 and its inverse, in integers throughout: what is stored is
/// the adjugate W = D·B⁻¹ with D = det B > 0, kept so by the integer-preserving pivot of Edmonds and Bareiss,
///
///     W_r ← (y_p W_r - y_r W_p) / D  (exactly divisible),   D ← y_p,   y = W a_entering,
///
/// so that no number ever exceeds a minor of the data. The right-hand side is e_m, hence D·x_B is the last
/// column of W. The first basis consists of artificial columns e_1, …, e_m; one that leaves never returns.
class ExactBasis {
 public:
  static constexpr std::ptrdiff_t kArtificial = -1;

  /// One pivot: the column that left, and whether the step was longer than zero.
  struct Step {
    std::ptrdiff_t left = kArtificial;
    bool moved = false;
  };

  explicit ExactBasis(int rows);

  int rows() const noexcept { return static_cast<int>(basic_.size()); }

  /// D > 0.
  const Integer& determinant() const noexcept { return D_; }

  /// The column that is basic in a row, or kArtificial.
  std::ptrdiff_t column(int row) const noexcept { return basic_[static_cast<std::size_t>(row)]; }

  /// D·x of the basic variable of a row; >= 0.
  const Integer& scaled_value(int row) const noexcept { return W(row, rows() - 1); }

  /// Adds row r of W to `sum`: D·e_r·B⁻¹, from which duals are made.
  void add_row(int row, IntegerVector& sum) const;

  /// Pivots column j, whose entries are `a`, into the basis. The leaving variable is found by the ratio test
  /// on exact ratios; among ties an artificial one leaves first, or with `bland` the one of the smallest
  /// index. Throws Error if no variable leaves, which the
  /// linear program, bounded below by 0, excludes for a column that improves.
  Step enter(std::ptrdiff_t j, const IntegerVector& a, bool bland);

 private:
  const Integer& W(int row, int k) const noexcept {
    return W_[static_cast<std::size_t>(row) * basic_.size() + static_cast<std::size_t>(k)];
  }
  Integer& W(int row, int k) noexcept {
    return W_[static_cast<std::size_t>(row) * basic_.size() + static_cast<std::size_t>(k)];
  }
  void multiply(const IntegerVector& a);
  int leaving_row(bool bland) const;
  void pivot(int row);

  std::vector<std::ptrdiff_t> basic_;
  IntegerVector W_;  ///< row-major
  Integer D_ = 1;
  IntegerVector y_;  ///< W a
};

}  // namespace raygauge
