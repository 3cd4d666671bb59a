// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// Whether so many multiplications with additions, of matrices and in vectors, fit into what the time limit
/// leaves: nothing looks at the clock among them. What takes no time to speak of always does.
inline bool affords(const Stopwatch& stopwatch, double operations) {
  constexpr double kSeconds = 4e-10;    // of one, on a slow or busy machine
  constexpr double kNegligible = 0.02;  // seconds
  return !stopwatch.limited() || operations * kSeconds <= std::max(stopwatch.remaining(), kNegligible);
}

constexpr double cube(double m) { return m * m * m; }

}  // namespace raygauge
