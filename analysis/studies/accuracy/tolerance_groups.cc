// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/tolerance_groups.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace raygauge::report {

std::vector<ToleranceCurve> tolerance_curves(const std::vector<Record>& records) {
  const std::vector<std::string> methods = methods_of(records);
  std::map<std::tuple<CellKey, std::ptrdiff_t>, ToleranceCurve> curves;
  for (const Record& record : records) {
    CellKey cell = cell_key(record);
    cell.tolerance = 0;
    const auto rank = std::find(methods.begin(), methods.end(), record.method) - methods.begin();
    ToleranceCurve& curve = curves[{cell, rank}];
    if (curve.records.empty()) {
      curve.method = record.method;
      curve.facets = {
          problem_facets(cell).front(), {"n", std::to_string(cell.n)}, {"N", std::to_string(cell.N)}};
    }
    curve.records[record.tolerance].push_back(&record);
  }
  std::vector<ToleranceCurve> result;
  for (auto& [key, curve] : curves) {
    if (curve.records.size() > 1) result.push_back(std::move(curve));
  }
  return result;
}

}  // namespace raygauge::report
