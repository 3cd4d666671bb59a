// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "analysis/data/aggregate.h"
#include "analysis/data/cell_ratio.h"
#include "analysis/data/filter.h"
#include "analysis/statistics/statistics.h"
#include "raygauge/sweep/record.h"
#include "results/schema/column.h"

namespace raygauge {

struct PivotOptions {
  std::vector<std::string> rows;     ///< names of columns
  std::vector<std::string> columns;  ///< names of columns; may be empty: one column, the value
  std::string value = "median milliseconds";
  Filter filter;
  std::vector<std::string> baselines;  ///< of "ratio"; empty: default_baselines()
};

struct PivotCell {
  /// NaN where there is nothing to aggregate: no record, or none that agrees. +infinity for times that are
  /// unsolved too often to have the aggregate asked for.
  double value = std::numeric_limits<double>::quiet_NaN();
  std::optional<Interval> interval;  ///< 95 %: for medians, and for the ratio in one cell of the grid
  std::size_t records = 0;
  std::size_t unsolved = 0;       ///< records that stopped at a limit
  std::size_t disagreeing = 0;    ///< records that contradict others: counted, never averaged in
  std::size_t without_value = 0;  ///< records whose value is NaN, as a gap where nothing was certified
};

/// A pivot of records. Records go to the cell of their row and column key; a cell aggregates the values of
/// its records that agree. Where the aggregate would mix different generators, methods or tolerances, the
/// table is split by them: they become the first rows (`split_by`). Counts may mix, and so may the pairs of a
/// Pool.
///
/// The quantity "ratio" is defined for a method in a cell of the grid (generator and its parameters, n, N,
/// tolerance), as median time over the best baseline's (CellRatio): several of those in one pivot cell are
/// aggregated as any other values; where there is just one it is its own median, geomean, ….
struct Pivot {
  Aggregate value;
  std::vector<std::string> row_names;  ///< with those the table was split by
  std::vector<std::string> split_by;
  std::vector<std::string> column_names;
  std::vector<std::vector<Value>> row_keys;     ///< sorted: numbers by size, texts by first appearance
  std::vector<std::vector<Value>> column_keys;  ///< likewise; one empty key without column_names
  std::vector<PivotCell> cells;                 ///< row by row
  std::vector<std::string> baselines;           ///< where value is a ratio
  std::size_t pooled = 0;                       ///< pairs of the user's own that cells mix; see Pool

  const PivotCell& cell(std::size_t row, std::size_t column) const {
    return cells[row * column_keys.size() + column];
  }
};

/// Throws UnknownNameError and InvalidParameterError for options that name what is not there, and
/// EmptySetError if no record passes the filter.
Pivot make_pivot(const std::vector<Record>& records, const PivotOptions& options);

}  // namespace raygauge
