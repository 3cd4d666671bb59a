// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/lp/basis.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// Elimination with complete pivoting: independent columns of a matrix and rows where they are so.
class Elimination {
 public:
  struct Pivot {
    int row;
    int column;
  };

  /// Of columns of m entries, one after the other, which count by their weights; of the `most` with the
  /// largest weighted entries. The pivots are fewer where ranks end or the stopwatch does.
  void choose(int m, const std::vector<double>& columns, const std::vector<double>& weights,
              std::ptrdiff_t most, const Kernels& kernels, const Stopwatch& stopwatch,
              std::vector<Pivot>& pivots);

 private:
  void scale(int m, const std::vector<double>& columns, const std::vector<double>& weights);
  Pivot clear_row_of(int m, int column, const Kernels& kernels);
  double* column(int i, int m) noexcept { return eliminated_.data() + std::ptrdiff_t{i} * padded_rows(m); }

  AlignedBuffer<double> eliminated_;  // columns, padded
  std::vector<double> largest_;       // entry of each of them
  std::vector<int> left_;             // of them: those that are no pivots yet
};

/// The optimal face of  min c·x, M x = b, x >= 0  as an interior-point method sees it: the columns that carry
/// weight, with their weights. Of rank r, however degenerate the optimum is: with r pivot columns P and rows
/// R, the weights x_P = M_RP⁻¹ (b - M x)_R of the pivots follow from the others, which stay as they are, and
/// are enclosed. That they solve all equations is a statement about ranks (columns_span). So a basis of m
/// columns, of which most have weight zero, is not needed.
class OptimalFace {
 public:
  void begin(int m, const Kernels& kernels);
  /// A column of m entries, copied; cost 0 or 1.
  void add(const double* column, double cost, double weight, std::int64_t id);
  int count() const noexcept { return static_cast<int>(ids_.size()); }

  /// Chooses the pivots, of the `most` columns with the largest weighted entries. False where there are none.
  bool choose(const Stopwatch& stopwatch, std::ptrdiff_t most = std::numeric_limits<std::ptrdiff_t>::max());
  int rank() const noexcept { return static_cast<int>(pivots_.size()); }
  int pivot_row(int i) const { return pivots_[static_cast<std::size_t>(i)].row; }  ///< i < rank()

  /// Σ c_i x_i of a solution that is proven to be positive, rounded up, for b = e_m; +infinity where none is.
  /// The weights of the pivots become that solution, to a double.
  double upper(const Stopwatch& stopwatch);

  /// Whether Σ c_i x_i is proven to be 0, with columns that are independent: of those that are not, some are
  /// left out, unless the stopwatch leaves no time for it. Their weights are the solution then, to a double.
  bool is_independent_zero(const Stopwatch& stopwatch);

  /// After upper(): whether the weights of the pivots are proven to be those of the solution as they round.
  bool is_rounded() const noexcept { return rounded_; }

  /// After upper(): duals y (m doubles) become y + y_low, at which the reduced costs of all columns are zero
  /// to some 30 digits where they were nearly.
  void refine_duals(double* y, double* y_low);

  /// For Farkas directions u (m doubles, nearly orthogonal to all columns): changes u to u + u_low in the
  /// pivot rows by so little that within the error returned of it, in these coordinates, there is one that is
  /// exactly orthogonal. +infinity where that is not proven.
  double enclose_orthogonal(double* u, double* u_low, const Stopwatch& stopwatch);

  double weight(int i) const { return weights_[static_cast<std::size_t>(i)]; }
  std::int64_t id(int i) const { return ids_[static_cast<std::size_t>(i)]; }
  const double* column(int i) const { return columns_.data() + static_cast<std::ptrdiff_t>(i) * m_; }

 private:
  using Pivot = Elimination::Pivot;

  void take_pivots();
  bool leave_others_out();
  void leave_out(int j);
  void keep_heavier_than(double least);
  bool is_zero_as_chosen(const Stopwatch& stopwatch);
  bool may_solve(double error) const;
  bool spans(bool with_right_hand_side, const Stopwatch& stopwatch);
  double enclose(Basis& basis, double error_of_b);
  double refine(Basis& basis);
  double set_right_hand_side();

  int m_ = 0;
  const Kernels* kernels_ = nullptr;
  std::vector<double> columns_;  // m entries each
  std::vector<double> costs_, weights_;
  std::vector<std::int64_t> ids_;
  Elimination elimination_;
  std::vector<Pivot> pivots_;
  std::vector<bool> is_pivot_;  // of columns
  std::vector<double> work_;
  std::vector<double> b_low_;  // of the right-hand side at hand
  bool rounded_ = false;
  Basis basis_;       // M_RP
  Basis transposed_;  // its transpose
  AlignedBuffer<double> x_low_;
};

}  // namespace raygauge
