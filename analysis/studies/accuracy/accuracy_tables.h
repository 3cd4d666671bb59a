// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/data/filter.h"
#include "analysis/data/record_groups.h"
#include "analysis/render/table.h"
#include "analysis/studies/accuracy/accuracy.h"

namespace raygauge {

/// The curves of one generator at one (n, N), all its parameters together.
struct AccuracyGroup {
  std::string name;  ///< "example2, n = 3, N = 200"
  std::vector<AccuracyCurve> curves;
};

/// The groups of all records, in order of first appearance. `exact` methods are where truths come from, and
/// are left out.
std::vector<AccuracyGroup> accuracy_groups(const RecordGroups& records, const Truth& truth);

/// Those of the records that pass, the truth being that of all. Throws EmptySetError where nothing is left.
std::vector<AccuracyGroup> accuracy_groups(const std::vector<Record>& records, const Filter& filter = {});

/// For reading: for each group a table with one line a method and tolerance; then one line a group and
/// method: where the method stops getting better, and what a digit costs until there.
std::vector<Table> accuracy_tables(const std::vector<AccuracyGroup>& groups);

/// For CSV: one row a group, method and tolerance.
Table accuracy_long_table(const std::vector<AccuracyGroup>& groups);

}  // namespace raygauge
