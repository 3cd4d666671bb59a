// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/statistics/paired_ratio.h"
#include "analysis/studies/table3/cell_ratio.h"
#include "engine/sweep/record.h"

namespace raygauge {

struct CompareOptions {
  double threshold = 0.05;  ///< changes up to ratio 1 + threshold, or down to 1 / (1 + threshold), are none
  double significance = 0.05;      ///< probability of one false alarm or more in the whole comparison
  double confidence = 0.95;        ///< of the intervals
  Filter filter;                   ///< on the records of both runs
  std::string base_name = "BASE";  ///< in what is said of the runs
  std::string new_name = "NEW";
};

enum class Change : unsigned char { none, faster, slower };

/// "none", "faster", "slower".
const char* to_string(Change change) noexcept;

/// One method in one cell of the grid, in both runs.
struct CellChange {
  CellKey cell;
  std::string method;
  std::size_t base_count = 0;
  std::size_t new_count = 0;
  std::size_t pairs = 0;    ///< instances with an answer in at least one run and a record in both
  double base_seconds = 0;  ///< median; records without has_answer() count as +infinity
  double new_seconds = 0;
  Ratio medians;          ///< ratio_of_medians()
  TestedRatio ratio;      ///< new / base: paired_ratio() and signed_rank_p(); without pairs: medians and
                          ///< rank_sum_p()
  double adjusted_p = 1;  ///< holm_adjusted() over all cells and methods
  std::size_t lost = 0;   ///< instances of which base has_answer() and new has not
  Change change = Change::none;
};

/// One method over all its cells: geometric_mean_ratio() of the cells' ratios.
struct MethodChange {
  std::string method;
  std::size_t cells = 0;
  TestedRatio ratio;
  double adjusted_p = 1;
  std::size_t lost = 0;
  Change change = Change::none;
};

/// Two runs of the same grid. The p values are of the hypothesis that the ratio is no further from 1 than the
/// threshold: a change is one whose adjusted p value is below the significance, so that a machine that drifts
/// by less than the threshold raises no alarm however often it is measured.
struct Comparison {
  CompareOptions options;
  std::vector<CellChange> cells;  ///< by generator, n, N, tolerance; methods in order of first appearance
  std::vector<MethodChange> methods;
  std::size_t base_only = 0;  ///< cells and methods that only one of the runs has
  std::size_t new_only = 0;
  std::size_t contradictions = 0;  ///< instances whose certified bounds of both runs exclude each other

  /// Something got slower, an instance is no longer solved or its answer now disagrees with other methods',
  /// or the runs contradict each other.
  bool regressed() const;
};

/// Compares records of the same cells and methods (by label). Throws EmptySetError if no record of one of
/// them passes the filter or the two have no cell and method in common, InvalidParameterError for a threshold
/// below 0 or a significance or confidence outside (0, 1).
Comparison compare_runs(const std::vector<Record>& base, const std::vector<Record>& fresh,
                        const CompareOptions& options = {});

}  // namespace raygauge
