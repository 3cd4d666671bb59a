// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/render/figures/figure.h"
#include "analysis/statistics/statistics.h"

namespace raygauge {

/// Wilson's interval for the probability behind k successes in n trials: with z the quantile of the normal
/// distribution, z = 1.96 for 95 %, and p = k/n,
///
///     (p + z²/(2n) ± z √(p (1-p)/n + z²/(4n²))) / (1 + z²/n).
///
/// Throws InvalidParameterError unless k <= n and n > 0.
Interval share_interval(std::size_t k, std::size_t n);

/// The share of a method's answers that do not agree, in per cent with 95 % intervals, against its median
/// time: a point for each method but oracles, over all records. Of plans (raygauge_motionbench) it is the
/// share that is proven to collide. Unsolved records count as infinitely slow. Needs an answer that does not
/// agree.
Drawing wrong_share(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
