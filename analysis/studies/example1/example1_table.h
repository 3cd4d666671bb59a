// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/data/record_groups.h"
#include "analysis/render/table.h"
#include "analysis/studies/accuracy/accuracy.h"

namespace raygauge {

/// Which half of Example 1: Table I and Figure 5, or Table II and Figure 7.
enum class Example1Roles : std::uint8_t {
  cone_ellipsoid,  ///< A a truncated cone, Q an ellipsoid
  ellipsoid_cone,  ///< swapped
};

/// Tables I and II of the paper, measured: Example 1 at every tolerance the records have.
struct Example1Table {
  Example1Roles roles = Example1Roles::cone_ellipsoid;
  std::vector<AccuracyCurve> curves;   ///< of every method
  std::vector<std::string> baselines;  ///< that times are divided by; empty where there are none

  /// Mean time of a point over the smallest mean time among the baselines at its tolerance; NaN without one.
  double time_ratio(const AccuracyPoint& point) const;
};

/// Takes the records of generator example1 with those roles. `baselines` empty: all that are baselines by
/// their role. Throws EmptySetError where there are no such records, UnknownNameError for a baseline that has
/// none.
Example1Table make_example1_table(const std::vector<Record>& records, Example1Roles roles,
                                  const Filter& filter = {}, std::vector<std::string> baselines = {});

/// The same of all records, without curves where none is of Example 1 in those roles.
Example1Table example1_table_of(const RecordGroups& records, Example1Roles roles, const Truth& truth,
                                std::vector<std::string> baselines = {});

/// For reading: for each method a table with one line a tolerance and the paper's numbers beside (its
/// algorithm's for methods of raygauge, its active-set solver's for competitors), then a summary of what must
/// hold.
std::vector<Table> example1_tables(const Example1Table& table);

/// For CSV: one row a method and tolerance.
Table example1_long_table(const Example1Table& table);

}  // namespace raygauge
