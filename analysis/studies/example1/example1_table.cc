// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/example1/example1_table.h"

#include <algorithm>
#include <cmath>

#include "analysis/constants.h"
#include "analysis/data/cell_ratio.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr const char* kExample1 = "example1";

std::string roles_parameter(Example1Roles roles) {
  return roles == Example1Roles::cone_ellipsoid ? "roles=cone_ellipsoid" : "roles=ellipsoid_cone";
}

bool is_of_example1(const CellKey& cell, const std::string& roles) {
  return cell.generator == kExample1 && cell.generator_parameters.find(roles) != std::string::npos;
}

void require_methods(const std::vector<AccuracyCurve>& curves, const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const AccuracyCurve& curve : curves) known.push_back(curve.method);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UnknownNameError("method", name, known, "--baseline");
    }
  }
}

}  // namespace

double Example1Table::time_ratio(const AccuracyPoint& point) const {
  double best = kInfinity;
  for (const AccuracyCurve& curve : curves) {
    if (std::find(baselines.begin(), baselines.end(), curve.method) == baselines.end()) continue;
    for (const AccuracyPoint& other : curve.points) {
      if (other.tolerance == point.tolerance) best = std::min(best, other.mean_seconds);
    }
  }
  return std::isfinite(best) ? point.mean_seconds / best : kNaN;
}

Example1Table example1_table_of(const RecordGroups& records, Example1Roles roles, const Truth& truth,
                                std::vector<std::string> baselines) {
  const std::string parameter = roles_parameter(roles);
  std::vector<const Record*> kept;
  for (const RecordGroup& group : records) {
    if (is_of_example1(group.cell, parameter))
      kept.insert(kept.end(), group.records.begin(), group.records.end());
  }
  Example1Table table{roles, accuracy_curves(kept, truth), std::move(baselines)};
  if (!table.baselines.empty()) return table;
  for (const AccuracyCurve& curve : table.curves) {
    if (curve.facts.role == Role::baseline) table.baselines.push_back(curve.method);
  }
  return table;
}

Example1Table make_example1_table(const std::vector<Record>& records, Example1Roles roles,
                                  const Filter& filter, std::vector<std::string> baselines) {
  const std::vector<Record> kept = filtered(records, filter);
  Example1Table table = example1_table_of(kept, roles, Truth(records), std::move(baselines));
  if (table.curves.empty()) {
    throw EmptySetError(
        "the tables of Example 1 need records of generator example1 with " + roles_parameter(roles) +
        (filter.expression().empty() ? "; there are none"
                                     : "; none passes the filter '" + filter.expression() + "'"));
  }
  require_methods(table.curves, table.baselines);
  return table;
}

}  // namespace raygauge
