// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/cell_key.h"
#include "analysis/data/filter.h"
#include "analysis/data/method_list.h"
#include "analysis/data/record_groups.h"
#include "analysis/statistics/statistics.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// The times of one method in one cell.
struct CellTimes {
  CellKey cell;
  std::string method;
  std::string method_parameters;
  std::vector<double> seconds;  ///< of the records that agree; +infinity for unsolved ones
  std::size_t unsolved = 0;     ///< among them
  std::size_t disagreeing = 0;  ///< records whose times are left out
};

/// The middle of a method's times in a cell and its 95 % interval: of repetitions of one problem the median,
/// of a Pool, whose instances differ, the geometric mean of the solved ones. Infinite where half of them are
/// unsolved.
struct Center {
  double seconds = 0;
  Interval interval;
};

/// `seconds` are infinite where unsolved. Throws EmptySetError without times.
Center center_of(const CellKey& cell, const std::vector<double>& seconds);
Center center_of(const CellTimes& times);

/// "median", or "geometric mean" where all cells are of a Pool; with cells of both kinds, what is what.
std::string center_words(const std::vector<CellKey>& cells);

/// The times by cell, in order of (generator, n, N, tolerance), methods in order of first appearance.
std::vector<CellTimes> cell_times(const RecordGroups& records);

/// One method against the best baseline in one cell.
struct CellRatio {
  CellTimes times;
  std::string baseline;       ///< the one with the smallest center_of() times; "" where none has a finite one
  double median_seconds = 0;  ///< center_of() the method's times
  double baseline_seconds = 0;
  Ratio ratio;  ///< of the two, with 95 % interval; NaN where there is no baseline
};

/// Time of each method in each cell over that of the best of `baselines` there. Times are of the
/// solve alone: building a baseline's model is not held against it. Methods among `baselines` are left out,
/// and cells where none of a method's records agree.
std::vector<CellRatio> cell_ratios(const std::vector<Record>& records,
                                   const std::vector<Record>& baseline_records,
                                   const std::vector<std::string>& baselines);

/// The same of cell_times(): those of the numerators, and those of the baselines, among others or not.
std::vector<CellRatio> cell_ratios(const std::vector<CellTimes>& numerators,
                                   const std::vector<CellTimes>& denominators,
                                   const std::vector<std::string>& baselines);

/// What ratios divide by unless told otherwise, by label: the simplex methods of GLPK, with which the paper
/// compares; where there are none, all baselines by their role.
std::vector<std::string> default_baselines(const MethodList& methods);
std::vector<std::string> default_baselines(const std::vector<Record>& records);

/// Throws InvalidParameterError if `baselines` is empty, UnknownNameError for one that is not among the
/// methods.
void require_baselines(const MethodList& methods, const std::vector<std::string>& baselines);

/// The records that ratios divide by when the numerators are those of `all` that pass `filter`: the
/// baselines' records that pass it too; where none does (as in "method==newton"), the baselines' records on
/// the instances of those that pass.
/// Throws as require_baselines().
std::vector<Record> baseline_records(const std::vector<Record>& all, const Filter& filter,
                                     const std::vector<std::string>& baselines);

}  // namespace raygauge
