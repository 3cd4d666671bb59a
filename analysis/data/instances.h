// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/data/record_groups.h"

namespace raygauge {

/// Whether a record brought an answer: it is solved, and agrees with the other methods'.
bool has_answer(const Record& record);

/// The record's time in seconds, +infinity without an answer.
double answer_seconds(const Record& record);

/// The records of one method in one cell by instance: seed and repetition. They belong to somebody else.
struct MethodInstances {
  using Instance = std::pair<std::uint64_t, int>;
  std::string method;
  std::vector<std::pair<Instance, const Record*>> records;  ///< each instance once, sorted

  /// answer_seconds() of each.
  std::vector<double> seconds() const;
};

/// The records of every cell, methods in order of first appearance there. Valid as long as `records`.
std::map<CellKey, std::vector<MethodInstances>> instances_by_cell(const RecordGroups& records);

/// The records of both on each instance that they share.
std::vector<std::pair<const Record*, const Record*>> shared_instances(const MethodInstances& first,
                                                                      const MethodInstances& second);

}  // namespace raygauge
