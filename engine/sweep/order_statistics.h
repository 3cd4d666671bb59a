// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace raygauge {

/// The middle one of `values`, or the mean of the two in the middle. There is at least one, and no NaN.
double sample_median(std::vector<double> values);

/// The largest rank d >= 1 with 1 - 2 P(B < d) >= confidence for B ~ Binomial(count, 1/2); 0 if there is none
/// (for 95 %: below 6 values).
std::size_t order_statistic_rank(std::size_t count, double confidence = 0.95);

/// An interval whose ends are values of the sample.
struct OrderStatisticInterval {
  double lower = 0;
  double upper = 0;
};

/// The binomial order-statistic interval [x_(d), x_(m-d+1)] for the median of the population that x_(1) <= …
/// <= x_(m) are a sample of, d = order_statistic_rank(m, confidence); it is the inverse of the sign test, and
/// not interpolated. Covers the median of any continuous distribution with probability `confidence` or more
/// (Conover 1999, "Practical Nonparametric Statistics", section 3.2). Empty where there are too few values;
/// they hold no NaN. (Reports interpolate: see analysis/statistics/statistics.h. For a stopping rule the
/// plain interval is the cautious one.)
std::optional<OrderStatisticInterval> order_statistic_interval(std::vector<double> values,
                                                               double confidence = 0.95);

}  // namespace raygauge
