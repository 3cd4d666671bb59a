// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/data/cell_ratio.h"
#include "analysis/render/time_unit.h"
#include "analysis/statistics/power_law.h"

namespace raygauge {

/// The size that times are taken against.
enum class SizeAxis : unsigned char { n, N };

/// Median times of one method against one size, the other being fixed.
struct ScalingCurve {
  CellKey cell;  ///< of the curve's first point: all but the size on the axis is common
  std::string method;
  std::string method_parameters;
  std::vector<double> sizes;             ///< sorted
  std::vector<double> medians;           ///< seconds; center_of() times
  std::vector<Interval> intervals;       ///< of each, seconds
  std::vector<std::size_t> outliers;     ///< outlier_count() of each
  std::vector<std::size_t> counts;       ///< times of each
  std::vector<std::size_t> unsolved;     ///< of them, infinite
  std::vector<std::size_t> disagreeing;  ///< records left out, since their answers are refuted
};

/// The curves of every method and problem with at least `fewest` sizes; cells whose median is infinite are
/// left out.
std::vector<ScalingCurve> scaling_curves(const std::vector<CellTimes>& cells,
                                         const std::vector<std::string>& methods, SizeAxis axis,
                                         std::size_t fewest = 2);
std::vector<ScalingCurve> scaling_curves(const std::vector<Record>& records, SizeAxis axis,
                                         std::size_t fewest = 2);

/// seconds = factor · size^exponent over the medians of a curve with three sizes or more (two leave no
/// interval). Throws as fit_power_law().
PowerLaw fit_scaling(const ScalingCurve& curve);

/// What the curves' points are, as center_words() of their cells.
std::string center_words(const std::vector<ScalingCurve>& curves);

/// The unit for an axis of the curves' medians.
TimeUnit unit_of(const std::vector<ScalingCurve>& curves);

}  // namespace raygauge
