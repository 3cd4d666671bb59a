// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "raygauge/sets/point_set.h"
#include "raygauge/sweep/instance.h"

namespace raygauge {

/// The distance between two point sets as the linear program of Example 2 of Zheng & Yamane,
///
///     minimize Σβ_j   subject to   Σα_i a_i - Σβ_j q_j = 0,   Σα_i = 1,   α, β >= 0,
///
/// one column for each point: (a_i, 1) at cost 0 for i < N_A, then (-q_j, 0) at cost 1. Its dual is
///
///     maximize t   subject to   u·a_i <= -t,   -u·q_j <= 1.
///
/// A view: the columns are made from the sets when they are copied.
class GaugeLp {
 public:
  /// `method` names the asker in messages. Throws InvalidParameterError where a set is not a PointSet and
  /// DimensionMismatchError where the sets live in different spaces.
  GaugeLp(const Instance& instance, const std::string& method);

  const PointSet& A() const noexcept { return *A_; }
  const PointSet& Q() const noexcept { return *Q_; }

  /// n + 1.
  int rows() const noexcept { return A_->dimension() + 1; }

  /// N_A + N_Q.
  std::ptrdiff_t columns() const noexcept { return A_->size() + Q_->size(); }

  /// Right-hand side of a row, 0 <= row < rows(): e_{n+1}.
  double right_hand_side(int row) const noexcept { return row + 1 == rows() ? 1.0 : 0.0; }

  /// Cost of a column, 0 <= j < columns().
  double cost(std::ptrdiff_t j) const noexcept { return j < A_->size() ? 0.0 : 1.0; }

  /// Writes column j to `out` (rows() doubles); unchecked.
  void copy_column(std::ptrdiff_t j, double* out) const noexcept;

 private:
  std::shared_ptr<const PointSet> A_;
  std::shared_ptr<const PointSet> Q_;
};

}  // namespace raygauge
