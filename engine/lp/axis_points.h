// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// Of the points to be priced those on the coordinate axes, as cross-polytopes have them: such a point of Q
/// stands for an artificial column of the first basis, whose inverse remains diagonal but for one column.
class AxisPoints {
 public:
  /// Looks for the farthest point of every half-axis in R^n; a few numbers of each point decide.
  void find(const PricedPoints& points, int n);

  /// Whether every half-axis has one.
  bool complete() const noexcept { return found_ == 2 * n_; }
  bool any() const noexcept { return found_ > 0; }

  /// The index of the point on the positive or negative half-axis k, negative where there is none, and its
  /// distance from the origin.
  std::ptrdiff_t index(int k, bool positive) const { return index_[at(k, positive)]; }
  double length(int k, bool positive) const { return length_[at(k, positive)]; }

 private:
  static std::size_t at(int k, bool positive) { return 2 * static_cast<std::size_t>(k) + (positive ? 1 : 0); }
  void note(std::ptrdiff_t point, int k, double coordinate);

  int n_ = 0;
  int found_ = 0;
  AlignedBuffer<std::ptrdiff_t> index_;
  AlignedBuffer<double> length_;
};

}  // namespace raygauge
