// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/data/cell_ratio.h"
#include "analysis/data/filter.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// One method's part of Table III.
struct Table3Method {
  std::string method;
  std::vector<CellRatio> cells;        ///< by n, then N
  std::vector<CellRatio> above_half;   ///< those whose ratio exceeds half of the paper's
  std::size_t measured = 0;            ///< cells with a ratio
  double geometric_mean = 0;           ///< of the ratios of `measured` cells; NaN if there are none
  std::size_t compared = 0;            ///< those of them that the paper has too
  double compared_geometric_mean = 0;  ///< of the ratios of `compared` cells; NaN if there are none
  double paper_geometric_mean = 0;     ///< of the paper's ratios of the same cells
  double largest_relative_gap = 0;     ///< certified, over all records with bounds; NaN without any
  std::size_t records = 0;
  std::size_t above_tolerance = 0;  ///< records whose certified gap exceeds the tolerance, or is unknown
  std::size_t unsolved = 0;
  std::size_t disagreeing = 0;
};

/// The paper's Table III, measured: Example 2 at tolerance 1e-6, time of each method against the better of
/// GLPK's simplex methods.
struct Table3 {
  std::vector<Table3Method> methods;  ///< those that are no competitors (is_competitor())
  std::vector<std::string> baselines;
  std::size_t records = 0;  ///< of all methods, baselines included
  std::size_t disagreeing = 0;
};

/// Takes the records of generator example2 (or of the only generator there is) at tolerance 1e-6. `baselines`
/// empty: default_baselines(). Throws EmptySetError where there are none, InvalidParameterError where they
/// have several generators or sets of parameters, and as baseline_records().
Table3 make_table3(const std::vector<Record>& records, const Filter& filter = {},
                   std::vector<std::string> baselines = {});

}  // namespace raygauge
