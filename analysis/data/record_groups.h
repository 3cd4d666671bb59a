// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/data/cell_key.h"
#include "analysis/data/method_list.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// The records of one method, with one set of its parameters, in one cell; at least one. They belong to
/// somebody else.
struct RecordGroup {
  CellKey cell;
  std::vector<const Record*> records;  ///< in their order

  const Record& first() const { return *records.front(); }
};

/// All records by cell, method and its parameters, groups in order of first appearance: whoever summarises
/// records compares their texts here once, and not in every summary. Valid as long as the records.
class RecordGroups {
 public:
  RecordGroups() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): whoever has records has groups of them
  RecordGroups(const std::vector<Record>& records);

  auto begin() const noexcept { return groups_.begin(); }
  auto end() const noexcept { return groups_.end(); }
  bool empty() const noexcept { return groups_.empty(); }

  /// Of all records, as methods_of().
  const MethodList& methods() const noexcept { return methods_; }

 private:
  std::vector<RecordGroup> groups_;
  MethodList methods_;
};

}  // namespace raygauge
