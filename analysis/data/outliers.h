// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/statistics/statistics.h"

namespace raygauge {

/// Tukey's fences: with quartiles q1 and q3 (quantile()), [q1 - k (q3 - q1), q3 + k (q3 - q1)]; k = 1.5 is
/// his definition of an outlier. Values outside are flagged, never dropped: a median hardly feels them, and a
/// slow solve may be the very thing to look at. Throws as quantile(), and InvalidParameterError for a
/// negative k. Infinite quartiles give infinite fences. The interval's confidence is 0: it is none.
Interval tukey_fences(const std::vector<double>& values, double k = 1.5);

/// Values outside tukey_fences(); infinite ones (unsolved) are counted elsewhere and not here.
std::size_t outlier_count(const std::vector<double>& values, double k = 1.5);

}  // namespace raygauge
