// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/instances.h"

#include <algorithm>

#include "analysis/constants.h"
#include "analysis/data/columns.h"

namespace raygauge {

bool has_answer(const Record& record) { return record.agrees && is_solved(record); }

double answer_seconds(const Record& record) { return has_answer(record) ? record.seconds : kInfinity; }

std::vector<double> MethodInstances::seconds() const {
  std::vector<double> result;
  for (const auto& [instance, record] : records) result.push_back(answer_seconds(*record));
  return result;
}

std::map<CellKey, std::vector<MethodInstances>> instances_by_cell(const std::vector<Record>& records) {
  std::map<CellKey, std::vector<MethodInstances>> cells;
  for (const Record& record : records) {
    std::vector<MethodInstances>& methods = cells[cell_key(record)];
    auto place = std::find_if(methods.begin(), methods.end(),
                              [&](const MethodInstances& each) { return each.method == record.method; });
    if (place == methods.end()) place = methods.insert(place, {record.method, {}});
    place->records[{record.seed, record.repetition}] = &record;
  }
  return cells;
}

std::vector<std::pair<const Record*, const Record*>> shared_instances(const MethodInstances& first,
                                                                      const MethodInstances& second) {
  std::vector<std::pair<const Record*, const Record*>> shared;
  for (const auto& [instance, record] : first.records) {
    const auto found = second.records.find(instance);
    if (found != second.records.end()) shared.emplace_back(record, found->second);
  }
  return shared;
}

}  // namespace raygauge
