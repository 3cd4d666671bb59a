// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/paired_ratio.h"

#include <cmath>
#include <string>

#include "analysis/constants.h"
#include "analysis/statistics/student_t.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void require_positive_time(double value) {
  if (!(value > 0))
    throw InvalidParameterError("a paired ratio needs positive values, not " + std::to_string(value));
}

/// Variance of the mean: Σ (x - mean)² / (count (count - 1)).
double variance_of_mean(const std::vector<double>& values, double center) {
  double sum = 0;
  for (const double x : values) sum += (x - center) * (x - center);
  const auto count = static_cast<double>(values.size());
  return sum / (count * (count - 1));
}

}  // namespace

std::vector<double> log_ratios(const std::vector<double>& numerator, const std::vector<double>& denominator) {
  if (numerator.size() != denominator.size()) {
    throw DimensionMismatchError("paired ratio: " + std::to_string(numerator.size()) + " numerators, " +
                                 std::to_string(denominator.size()) + " denominators");
  }
  std::vector<double> logs;
  for (std::size_t i = 0; i < numerator.size(); ++i) {
    require_positive_time(numerator[i]);
    require_positive_time(denominator[i]);
    if (std::isinf(numerator[i]) && std::isinf(denominator[i])) continue;
    logs.push_back(std::log(numerator[i]) - std::log(denominator[i]));
  }
  return logs;
}

Ratio paired_ratio(const std::vector<double>& numerator, const std::vector<double>& denominator,
                   double confidence) {
  const std::vector<double> logs = log_ratios(numerator, denominator);
  if (logs.empty()) return {kNaN, {kNaN, kNaN, 0}};
  const Interval interval = median_interval(logs, confidence);
  return {std::exp(median(logs)), {std::exp(interval.lower), std::exp(interval.upper), interval.confidence}};
}

TestedRatio geometric_mean_ratio(const std::vector<double>& logarithms, double confidence) {
  std::vector<double> logs;
  for (const double x : logarithms) {
    if (std::isfinite(x)) logs.push_back(x);
  }
  if (logs.empty()) return {{kNaN, {kNaN, kNaN, 0}}, 1};
  const double center = mean(logs);
  if (logs.size() < 2) return {{std::exp(center), {0, kInfinity, confidence}}, 1};
  const double error = std::sqrt(variance_of_mean(logs, center));
  const std::size_t freedom = logs.size() - 1;
  const double half = error * student_t_quantile(freedom, (1 + confidence) / 2);
  TestedRatio result;
  result.ratio = {std::exp(center), {std::exp(center - half), std::exp(center + half), confidence}};
  if (error > 0) {
    result.p = 2 * student_t_tail(freedom, std::abs(center) / error);
  } else {
    result.p = center == 0 ? 1 : 0;
  }
  return result;
}

}  // namespace raygauge
