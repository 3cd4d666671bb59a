// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// Points with weights, whose combination Σ w_i p_i is of interest as well as its parts.
class WeightedPoints {
 public:
  void clear(int n) noexcept {
    n_ = n;
    count_ = 0;
  }
  void add(const double* point, double weight) {
    const auto size = static_cast<std::size_t>(n_);
    const auto count = static_cast<std::size_t>(count_) + 1;
    points_.reserve(count * size);
    weights_.reserve(count);
    std::copy_n(point, n_, points_.data() + static_cast<std::size_t>(count_) * size);
    weights_[static_cast<std::size_t>(count_++)] = weight;
  }

  /// Multiplies every point by `factor`, a power of two.
  void scale(double factor) noexcept {
    const auto size = static_cast<std::size_t>(count_) * static_cast<std::size_t>(n_);
    for (std::size_t k = 0; k < size; ++k) points_[k] *= factor;
  }

  /// The combination with weights that are not negative and add up to 1, n doubles: a point of the hull up to
  /// the rounding of its coordinates. False where no weight is positive.
  bool average(double* point) const noexcept {
    double sum = 0;
    for (int i = 0; i < count_; ++i) sum += std::max(weight(i), 0.0);
    if (!(sum > 0)) return false;
    std::fill_n(point, n_, 0.0);
    for (int i = 0; i < count_; ++i) {
      const double share = std::max(weight(i), 0.0) / sum;
      for (int k = 0; k < n_; ++k) point[k] += share * this->point(i)[k];
    }
    return true;
  }

  int count() const noexcept { return count_; }
  const double* point(int i) const noexcept { return points_.data() + std::ptrdiff_t{i} * n_; }
  double weight(int i) const noexcept { return weights_[static_cast<std::size_t>(i)]; }

 private:
  int n_ = 0;
  int count_ = 0;
  AlignedBuffer<double> points_;
  AlignedBuffer<double> weights_;
};

}  // namespace raygauge
