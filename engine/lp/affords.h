// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/kernels/kernel.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// Whether so many multiplications with additions, of matrices and in vectors, fit into what the time limit
/// leaves: nothing looks at the clock among them. Those of vector kernels count once a vector. What takes no
/// time to speak of always does.
inline bool affords(const Stopwatch& stopwatch, double operations) {
  constexpr double kSeconds = 4e-10;    // of one, on a slow or busy machine
  constexpr double kNegligible = 0.02;  // seconds
  return !stopwatch.limited() || operations * kSeconds <= std::max(stopwatch.remaining(), kNegligible);
}

constexpr double cube(double m) { return m * m * m; }

/// The same of the inverse of m columns by vector kernels.
inline bool affords_inverse(const Stopwatch& stopwatch, int m, const Kernels& kernels) {
  return affords(stopwatch, 2 * cube(m) / kernels.width);
}

/// Whether a loop has time for its next step, by the longest of those before.
class StepTimes {
 public:
  /// Asked before every step; the first is reckoned by its operations.
  bool affords_next(const Stopwatch& stopwatch, double operations) {
    if (!stopwatch.limited()) return true;
    constexpr double kSpare = 2;
    const double remaining = stopwatch.remaining();
    const bool first = before_ == 0;
    if (!first) longest_ = std::max(longest_, before_ - remaining);
    before_ = remaining;
    return first ? affords(stopwatch, operations) : kSpare * longest_ <= remaining;
  }

 private:
  double before_ = 0;   // seconds that remained before the last step
  double longest_ = 0;  // seconds
};

}  // namespace raygauge
