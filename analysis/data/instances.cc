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

namespace {

/// Sorts by instance; of several records of one, the last one stays.
void arrange(MethodInstances& method) {
  auto& records = method.records;
  const auto before = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::reverse(records.begin(), records.end());
  std::stable_sort(records.begin(), records.end(), before);
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  records.erase(std::unique(records.begin(), records.end(), same), records.end());
}

}  // namespace

std::map<CellKey, std::vector<MethodInstances>> instances_by_cell(const RecordGroups& records) {
  std::map<CellKey, std::vector<MethodInstances>> cells;
  for (const RecordGroup& group : records) {
    std::vector<MethodInstances>& methods = cells[group.cell];
    const std::string& method = group.first().method;
    auto place = std::find_if(methods.begin(), methods.end(),
                              [&](const MethodInstances& each) { return each.method == method; });
    if (place == methods.end()) place = methods.insert(place, {method, {}});
    for (const Record* record : group.records)
      place->records.emplace_back(MethodInstances::Instance(record->seed, record->repetition), record);
  }
  for (auto& [cell, methods] : cells)
    for (MethodInstances& method : methods) arrange(method);
  return cells;
}

std::vector<std::pair<const Record*, const Record*>> shared_instances(const MethodInstances& first,
                                                                      const MethodInstances& second) {
  std::vector<std::pair<const Record*, const Record*>> shared;
  auto other = second.records.begin();
  for (const auto& [instance, record] : first.records) {
    while (other != second.records.end() && other->first < instance) ++other;
    if (other == second.records.end()) break;
    if (other->first == instance) shared.emplace_back(record, other->second);
  }
  return shared;
}

}  // namespace raygauge
