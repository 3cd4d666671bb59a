// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/tolerance_groups.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace raygauge::report {

std::vector<ToleranceCurve> tolerance_curves(const RecordGroups& records) {
  const std::vector<std::string>& methods = records.methods();
  std::map<std::tuple<CellKey, std::ptrdiff_t>, ToleranceCurve> curves;
  for (const RecordGroup& group : records) {
    CellKey cell = group.cell;
    cell.tolerance = 0;
    const std::string& method = group.first().method;
    const auto rank = std::find(methods.begin(), methods.end(), method) - methods.begin();
    ToleranceCurve& curve = curves[{cell, rank}];
    if (curve.records.empty()) {
      curve.method = method;
      curve.facets = {
          problem_facets(cell).front(), {"n", std::to_string(cell.n)}, {"N", std::to_string(cell.N)}};
    }
    std::vector<const Record*>& own = curve.records[group.cell.tolerance];
    own.insert(own.end(), group.records.begin(), group.records.end());
  }
  std::vector<ToleranceCurve> result;
  for (auto& [key, curve] : curves) {
    if (curve.records.size() > 1) result.push_back(std::move(curve));
  }
  return result;
}

}  // namespace raygauge::report
