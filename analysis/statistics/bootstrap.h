// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "analysis/statistics/statistics.h"

namespace raygauge {

struct BootstrapOptions {
  double confidence = 0.95;
  int resamples = 2000;
  std::uint64_t seed = 1;  ///< the same seed gives the same interval on every machine
};

/// Percentile bootstrap interval (Efron) of any statistic: its quantiles (type 7) of orders (1 ± confidence)
/// / 2 over resamples of `values` with replacement. For the median, median_interval() is exact and cheaper;
/// this one is for statistics that have no such interval. Throws EmptySetError without values,
/// InvalidParameterError for options out of range.
Interval bootstrap_interval(const std::vector<double>& values,
                            const std::function<double(const std::vector<double>&)>& statistic,
                            const BootstrapOptions& options = {});

}  // namespace raygauge
