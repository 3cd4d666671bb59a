// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/cell_ratio.h"
#include "analysis/data/filter.h"
#include "analysis/statistics/paired_ratio.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

struct CompareOptions {
  double threshold = 0.05;  ///< changes up to ratio 1 + threshold, or down to 1 / (1 + threshold), are none
  double significance = 0.05;      ///< probability of one false alarm or more in the whole comparison
  double confidence = 0.95;        ///< of the intervals
  bool paired = false;             ///< run i of one side belongs to run i of the other, in random order
  Filter filter;                   ///< on the records of all runs
  std::string base_name = "BASE";  ///< in what is said of the runs
  std::string new_name = "NEW";
};

/// The records of each run of one side.
using Runs = std::vector<std::vector<Record>>;

/// Suspected: the solves of the two sides differ, but so might two runs of the same build.
enum class Change : unsigned char { none, faster, slower, suspected_faster, suspected_slower };

/// "none", "faster", "slower", "suspected faster", "suspected slower".
const char* to_string(Change change) noexcept;

/// What was found out about one ratio NEW / BASE.
struct Finding {
  TestedRatio ratio;      ///< p: within runs, that it is no further from 1 than the threshold
  double adjusted_p = 1;  ///< the same, holm_adjusted() over all cells and methods
  double run_p = 1;       ///< between runs (test_pairs(), test_runs()); 1 where one run a side says nothing
  double run_spread = 0;  ///< standard deviation of a run's log time between runs; NaN with one run a side
  std::size_t lost = 0;   ///< instances that base solved (in most of its runs) and new did not
  Change change = Change::none;
};

/// One method in one cell of the grid, on both sides.
struct CellChange : Finding {
  CellKey cell;
  std::string method;
  std::size_t base_count = 0;
  std::size_t new_count = 0;
  std::size_t pairs = 0;    ///< instances with an answer on at least one side and a record on both
  double base_seconds = 0;  ///< median; records without has_answer() count as +infinity
  double new_seconds = 0;
  Ratio medians;                   ///< ratio_of_medians()
  std::vector<double> run_values;  ///< RunSeries::values
};

/// One method over all its cells: geometric_mean_ratio() of the cells' ratios.
struct MethodChange : Finding {
  std::string method;
  std::size_t cells = 0;
};

/// Two sides that ran the same grid (docs/analysis.md, Compare two runs).
struct Comparison {
  CompareOptions options;
  std::size_t base_runs = 1;
  std::size_t new_runs = 1;
  std::vector<CellChange> cells;  ///< by generator, n, N, tolerance; methods in order of first appearance
  std::vector<MethodChange> methods;
  std::size_t base_only = 0;  ///< cells and methods that only one of the sides has
  std::size_t new_only = 0;
  std::size_t contradictions = 0;  ///< instances whose certified bounds on both sides exclude each other

  /// Something got slower, an instance is no longer solved or its answer now disagrees with other methods',
  /// or the sides contradict each other.
  bool regressed() const;
  /// Something may have become slower.
  bool suspicious() const;
};

/// By how much the time of a cell, and the mean log time of a method, have been seen to change between two
/// runs of one build on a machine that other processes kept busy: of 100 such pairs on two cores under a load
/// of 6 to 9 (16 cells, 20 solves each) the largest changes were 1.90 and 1.41.
inline constexpr double kLargestCellDrift = 2;
inline constexpr double kLargestMethodDrift = 1.5;

/// Compares records of the same cells and methods (by label). Throws EmptySetError if a run has no record
/// that passes the filter or the two sides have no cell and method in common, InvalidParameterError for a
/// threshold below 0, a significance or confidence outside (0, 1), or pairs of unequal numbers of runs.
Comparison compare_runs(const Runs& base, const Runs& fresh, const CompareOptions& options = {});

/// The same with one run a side.
Comparison compare_runs(const std::vector<Record>& base, const std::vector<Record>& fresh,
                        const CompareOptions& options = {});

}  // namespace raygauge
