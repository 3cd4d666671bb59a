// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/statistics/statistics.h"

namespace raygauge {

/// y = factor · x^exponent.
struct PowerLaw {
  double exponent = 0;
  double factor = 0;
  Interval exponent_interval;  ///< infinite with two points, which leave nothing to judge the scatter by
  Interval factor_interval;
  double residual = 0;   ///< standard error of log y about the line, √(RSS / (points - 2))
  double r_squared = 0;  ///< coefficient of determination of log y
  std::size_t points = 0;
};

/// Ordinary least squares of log y on log x, with Student's t intervals of points - 2 degrees of freedom.
/// Throws DimensionMismatchError for unequal lengths, InvalidParameterError for fewer than two distinct x, a
/// value that is not positive and finite, or a confidence outside (0, 1).
PowerLaw fit_power_law(const std::vector<double>& x, const std::vector<double>& y, double confidence = 0.95);

}  // namespace raygauge
