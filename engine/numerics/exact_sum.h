// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "engine/numerics/double_double.h"

namespace raygauge {

/// A sum of doubles and of products of two doubles without any rounding error, kept as a nonoverlapping
/// expansion (Shewchuk 1997).
class ExactSum {
 public:
  void add(double term) noexcept {
    std::size_t kept = 0;
    for (std::size_t c = 0; c < count_; ++c) {
      const DoubleDouble s = two_sum(term, component_[c]);
      if (s.low != 0) component_[kept++] = s.low;
      term = s.high;
    }
    if (term != 0) {
      if (kept == component_.size()) {
        exact_ = false;
        --kept;
      }
      component_[kept++] = term;
    }
    count_ = kept;
  }

  void add_product(double a, double b) noexcept {
    if (a == 0 || b == 0) return;
    const DoubleDouble p = two_product(a, b);
    if (!(std::fabs(p.high) > kUnderflowLimit)) exact_ = false;
    add(p.low);
    add(p.high);
  }

  /// True only if the sum is zero; false if it is not or if an underflow or overflow of the expansion leaves
  /// it open.
  bool is_zero() const noexcept { return exact_ && count_ == 0; }

  /// The sum to within `error`; an error of +infinity after an underflow or overflow.
  struct Rounded {
    double value = 0;
    double error = 0;
  };
  Rounded rounded() const noexcept {
    // From the smallest component on, no partial sum exceeds twice the largest component.
    double value = 0;
    for (std::size_t c = 0; c < count_; ++c) value += component_[c];
    if (!exact_ || !std::isfinite(value)) return {value, std::numeric_limits<double>::infinity()};
    const double largest = count_ > 0 ? std::fabs(component_[count_ - 1]) : 0.0;
    return {value, static_cast<double>(count_) * 0x1p-51 * largest};
  }

 private:
  static constexpr double kUnderflowLimit =
      0x1p-900;  // below, the error of a product may not be representable
  std::array<double, 48> component_{};
  std::size_t count_ = 0;
  bool exact_ = true;
};

}  // namespace raygauge
