// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/data/method_list.h"
#include "analysis/statistics/statistics.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// What makes two records comparable: the cell of a grid, by its values, so that files can be merged.
struct CellKey {
  std::string generator;
  std::string generator_parameters;
  int n = 0;
  int N = 0;
  double tolerance = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy sees a 0 in what the compiler generates
  friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

CellKey cell_key(const Record& record);

/// "example2 (separation=1.5)": the generator with its parameters, if it has any.
std::string problem_name(const CellKey& cell);

/// The times of one method in one cell.
struct CellTimes {
  CellKey cell;
  std::string method;
  std::string method_parameters;
  std::vector<double> seconds;  ///< of the records that agree; +infinity for unsolved ones
  std::size_t unsolved = 0;     ///< among them
  std::size_t disagreeing = 0;  ///< records whose times are left out
};

/// The times by cell, in order of (generator, n, N, tolerance), methods in order of first appearance.
std::vector<CellTimes> cell_times(const std::vector<Record>& records);

/// One method against the best baseline in one cell.
struct CellRatio {
  CellTimes times;
  std::string baseline;  ///< the one with the smallest median time; "" where no baseline has a finite one
  double median_seconds = 0;
  double baseline_seconds = 0;
  Ratio ratio;  ///< ratio of the medians, with 95 % interval; NaN where there is no baseline
};

/// Time of each method in each cell over the median time of the best of `baselines` there. Times are of the
/// solve alone: building a baseline's model is not held against it. Methods among `baselines` are left out,
/// and cells where none of a method's records agree.
std::vector<CellRatio> cell_ratios(const std::vector<Record>& records,
                                   const std::vector<Record>& baseline_records,
                                   const std::vector<std::string>& baselines);

/// What ratios divide by unless told otherwise, by label: the simplex methods of GLPK, with which the paper
/// compares; where there are none, all baselines by their role.
std::vector<std::string> default_baselines(const std::vector<Record>& records);

/// The records that ratios divide by when the numerators are those of `all` that pass `filter`: the
/// baselines' records that pass it too; where none does (as in "method==newton"), the baselines' records on
/// the instances of those that pass.
/// Throws InvalidParameterError if `baselines` is empty, UnknownNameError for one that has no record at all.
std::vector<Record> baseline_records(const std::vector<Record>& all, const Filter& filter,
                                     const std::vector<std::string>& baselines);

}  // namespace raygauge
