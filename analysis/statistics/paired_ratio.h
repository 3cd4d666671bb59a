// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/statistics/statistics.h"

namespace raygauge {

/// Two samples on the same instances: the median of numerator[i] / denominator[i], with the median_interval()
/// of the logarithms of these ratios. Where the instances differ more than the measurements do, it is far
/// narrower than ratio_of_medians(), whose two samples are independent. A pair of two infinities (neither
/// solved) says nothing and is left out; one infinity makes the ratio of its pair infinite or 0. Without any
/// pair left the ratio is NaN. Throws DimensionMismatchError for unequal lengths, InvalidParameterError for a
/// value that is not positive or a confidence outside (0, 1).
Ratio paired_ratio(const std::vector<double>& numerator, const std::vector<double>& denominator,
                   double confidence = 0.95);

/// log(numerator[i] / denominator[i]) of the pairs that paired_ratio() uses. Throws as it does.
std::vector<double> log_ratios(const std::vector<double>& numerator, const std::vector<double>& denominator);

/// A ratio that was measured several times, and the probability of so much under "the ratio is 1".
struct TestedRatio {
  Ratio ratio;
  double p = 1;  ///< two-sided
};

/// exp(mean of the logarithms) with the interval of Student's t for their mean, and its t test against 0: for
/// the ratios of many cells, of which each counts as one observation. Fewer than two finite logarithms leave
/// an infinite interval and p = 1; infinite ones are left out; without any the ratio is NaN.
TestedRatio geometric_mean_ratio(const std::vector<double>& logarithms, double confidence = 0.95);

}  // namespace raygauge
