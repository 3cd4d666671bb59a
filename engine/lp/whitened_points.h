// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/lp/column_pool.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// The points of two pools after a linear map that makes them round: a shear of both sets leaves the distance
/// as it is, and normal equations without digits. With evenly chosen points, 1.5 for each dimension, as the
/// rows of W R, W with orthogonal columns (Householder), the points here are w = R⁻ᵀ p, and u·p = (R u)·w.
class WhitenedPoints {
 public:
  /// False where the points do not span R^n, or nearly so, and where the time is over.
  bool compute(const ColumnPool& A, const ColumnPool& Q, int n, const Stopwatch& stopwatch);

  /// Until the next compute().
  PricedPoints A() const noexcept { return {A_.data(), blocks_A_, nullptr, 0, size_A_}; }
  PricedPoints Q() const noexcept { return {Q_.data(), blocks_Q_, nullptr, 0, size_Q_}; }

  void turn(double* u) const;       ///< u becomes R u
  void turn_back(double* u) const;  ///< u becomes R⁻¹ u

 private:
  int n_ = 0;
  std::ptrdiff_t size_A_ = 0, size_Q_ = 0, blocks_A_ = 0, blocks_Q_ = 0;
  AlignedBuffer<double> A_, Q_;  // in blocks, as of PointSet
  std::vector<double> R_;        // n x n, column-major
};

}  // namespace raygauge
