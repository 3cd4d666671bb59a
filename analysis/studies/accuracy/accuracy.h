// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/method_list.h"
#include "analysis/data/truth.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// All solves of one method at one tolerance. A solve's value is its `distance`, its error |distance -
/// truth|, if both are finite. Mean errors are of the solves with an answer (is_solved()): what the others
/// left is no accuracy, and is averaged only where no solve has an answer. Other averages are over all
/// solves. NaN where there is nothing to average.
struct AccuracyPoint {
  double tolerance = 0;
  std::size_t solves = 0;
  std::size_t failures = 0;    ///< stopped at a limit
  std::size_t wrong = 0;       ///< is_wrong(): answers off by more than 10 ε, bounds that exclude the truth
  std::size_t beyond_gap = 0;  ///< error > upper - lower + truth_rounding(), where there are two bounds
  std::size_t bounded = 0;     ///< solves with two finite bounds

  double mean_error = 0;              ///< absolute, as in the paper
  double mean_relative_error = 0;     ///< |distance - truth| / truth, truth > 0
  double largest_relative_error = 0;  ///< +∞ where a solve left no finite distance
  double mean_relative_gap = 0;       ///< (upper - lower) / upper; +∞ where a bound is missing
  double largest_relative_gap = 0;    ///< alike

  double mean_seconds = 0;
  double median_seconds = 0;
  double K = 0;         ///< mean outer_iterations
  double N_rs = 0;      ///< mean ray_iterations
  double supports = 0;  ///< mean support_queries / 2: one query of each set makes a point of A - a_c - Q
};

/// One method at all its tolerances, the loosest first.
struct AccuracyCurve {
  MethodFacts facts;
  std::string method;  ///< its label
  std::vector<AccuracyPoint> points;
};

/// The curves of the records, methods in order of first appearance.
std::vector<AccuracyCurve> accuracy_curves(const std::vector<const Record*>& records, const Truth& truth);

/// What the tightest tolerances brought a method.
struct AccuracyFloor {
  AccuracyPoint reached;  ///< where it stops getting better: no tighter ε halves the mean relative error
  double seconds_a_digit =
      0;                 ///< (median time there - at the loosest ε) / decades between; NaN for no decade
  double certified = 0;  ///< tightest ε at which every solve has a gap of at most ε; NaN for none
  bool still_improving = false;  ///< `reached` is the tightest ε there is
};

/// Throws EmptySetError for a curve without points.
AccuracyFloor accuracy_floor(const AccuracyCurve& curve);

}  // namespace raygauge
