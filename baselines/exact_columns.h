// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "baselines/exact_number.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

using IntegerVector = std::vector<Integer>;

/// The columns of the linear program of Example 2 (see GaugeLp), in integers: row k of the first n is
/// multiplied by 2^shift(k), the least power of two that makes every double of that row an integer. Such a
/// scaling of rows changes neither the optimum nor its weights. Entry n of a column is the one of Σα = 1, and
/// the cost follows as entry n + 1.
class ExactColumns {
 public:
  /// The sets must outlive the object. Throws DimensionMismatchError.
  ExactColumns(const PointSet& A, const PointSet& Q);

  /// n + 1.
  int rows() const noexcept { return A_->dimension() + 1; }
  std::ptrdiff_t count() const noexcept { return A_->size() + Q_->size(); }

  /// Columns from first_gauge() = N_A on belong to points of Q.
  std::ptrdiff_t first_gauge() const noexcept { return A_->size(); }
  bool is_gauge(std::ptrdiff_t j) const noexcept { return j >= first_gauge(); }

  long shift(int row) const noexcept { return shift_[static_cast<std::size_t>(row)]; }

  /// Column j and its cost, rows() + 1 integers.
  void copy(std::ptrdiff_t j, IntegerVector& out) const;

  /// Column j before scaling and its cost, rows() + 1 doubles.
  void copy(std::ptrdiff_t j, double* out) const noexcept;

 private:
  const PointSet* A_;
  const PointSet* Q_;
  std::vector<long> shift_;
};

/// p·(column j and its cost) for one vector p of rows() + 1 integers and any j: approximately and with a
/// bound on the error, or exactly.
class ExactProduct {
 public:
  /// Both must outlive the object.
  ExactProduct(const ExactColumns& columns, const IntegerVector& p);

  /// The sign of the product: -1, 0 or 1, and about how large it is (up to a factor common to all j; 0 where
  /// the numbers span too many binary orders to tell). Exact arithmetic is used only where rounding leaves
  /// doubt.
  struct Sign {
    int sign = 0;
    long double magnitude = 0;
  };
  Sign sign(std::ptrdiff_t j);

  Integer exact(std::ptrdiff_t j);

  /// Whether p = 0.
  bool is_zero() const noexcept { return is_zero_; }

 private:
  const ExactColumns& columns_;
  const IntegerVector& p_;
  std::vector<long double> scaled_p_;
  std::vector<double> column_;
  IntegerVector exact_column_;
  bool is_zero_ = true;
  bool in_range_ = true;
};

}  // namespace raygauge
