// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace raygauge {

/// When bounds are good enough: close to a relative `tolerance`, or both on one side of `threshold` (NaN: of
/// none).
struct Goal {
  double tolerance = 1e-6;
  double threshold = std::numeric_limits<double>::quiet_NaN();
};

/// What is proven of a number d >= 0: lower() <= d <= upper(). Bounds only ever get better, whoever works on
/// them, and a bound that is not a number proves nothing.
class Bounds {
 public:
  Bounds() = default;  // nothing is proven
  Bounds(double lower, double upper) noexcept {
    raise_lower(lower);
    reduce_upper(upper);
  }

  double lower() const noexcept { return lower_; }
  double upper() const noexcept { return upper_; }
  double gap() const noexcept { return upper_ - lower_; }

  /// Whether the bound is better than the one before: what proves it is then what proves these bounds.
  bool raise_lower(double bound) noexcept {
    if (!(bound > lower_)) return false;
    lower_ = bound;
    return true;
  }
  bool reduce_upper(double bound) noexcept {
    if (!(bound < upper_)) return false;
    upper_ = bound;
    return true;
  }

  /// No two proofs contradict each other; a set that breaks its own promises can lead there.
  bool agree() const noexcept { return lower_ <= upper_; }

  /// Whether they decide d to a relative `tolerance`, or to a gap that is `enough`. Bounds that contradict
  /// each other decide nothing.
  bool close(double tolerance, double enough = 0) const noexcept {
    return agree() && upper_ <= std::numeric_limits<double>::max() &&
           (gap() <= tolerance * upper_ || gap() <= enough);
  }
  bool reach(const Goal& goal) const noexcept {
    return lower_ > goal.threshold || upper_ < goal.threshold || close(goal.tolerance);
  }

  /// Those of d · 2^shift, rounded outward where they leave the normal range of doubles.
  Bounds scaled(int shift) const noexcept;

 private:
  double lower_ = 0;
  double upper_ = std::numeric_limits<double>::infinity();
};

/// value · 2^shift, rounded towards zero resp. +infinity where the result is not a normal number. value >= 0.
double scaled_down(double value, int shift) noexcept;
double scaled_up(double value, int shift) noexcept;

inline Bounds Bounds::scaled(int shift) const noexcept {
  return {scaled_down(lower_, shift), scaled_up(upper_, shift)};
}

}  // namespace raygauge
