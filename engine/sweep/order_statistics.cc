// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/order_statistics.h"

#include <algorithm>
#include <cmath>

namespace raygauge {

double sample_median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*std::max_element(values.begin(), middle) + *middle) / 2;
}

std::size_t order_statistic_rank(std::size_t count, double confidence) {
  // P(B = k) by logarithms, since 2^-count is no double for large counts. (std::lgamma writes a global.)
  double log_probability = -static_cast<double>(count) * std::log(2.0);
  double below = 0;  // P(B < k + 1)
  for (std::size_t k = 0; 2 * k < count; ++k) {
    below += std::exp(log_probability);
    if (1 - 2 * below < confidence) return k;
    log_probability += std::log(static_cast<double>(count - k) / static_cast<double>(k + 1));
  }
  return count / 2;
}

std::optional<OrderStatisticInterval> order_statistic_interval(std::vector<double> values,
                                                               double confidence) {
  const std::size_t rank = order_statistic_rank(values.size(), confidence);
  if (rank == 0) return std::nullopt;
  std::sort(values.begin(), values.end());
  return OrderStatisticInterval{values[rank - 1], values[values.size() - rank]};
}

}  // namespace raygauge
