// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/outliers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/constants.h"
#include "raygauge/exceptions.h"

namespace raygauge {

Interval tukey_fences(const std::vector<double>& values, double k) {
  if (!(k >= 0)) throw InvalidParameterError("Tukey's k is " + std::to_string(k) + ", must not be negative");
  const double q1 = quantile(values, 0.25);
  const double q3 = quantile(values, 0.75);
  if (!std::isfinite(q1) || !std::isfinite(q3)) return {-kInfinity, kInfinity, 0};
  return {q1 - k * (q3 - q1), q3 + k * (q3 - q1), 0};
}

std::size_t outlier_count(const std::vector<double>& values, double k) {
  const Interval fences = tukey_fences(values, k);
  return static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [&](double x) {
    return std::isfinite(x) && (x < fences.lower || x > fences.upper);
  }));
}

}  // namespace raygauge
