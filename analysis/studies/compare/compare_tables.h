// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/render/table.h"
#include "analysis/studies/compare/compare.h"

namespace raygauge {

/// A table of the methods as a whole, then one of the cells that got slower or faster, the most changed
/// first (at most `most_rows`, 0: all; a note says how many more); the notes name the tests. `warnings`
/// become notes of the last.
std::vector<Table> comparison_tables(const Comparison& comparison, const std::vector<std::string>& warnings,
                                     std::size_t most_rows = 20);

/// Every cell and method, one a line: for CSV.
Table comparison_long_table(const Comparison& comparison);

/// The outcome in one line: "no regression: …", "suspected regression: …" or "REGRESSION: …".
std::string comparison_verdict(const Comparison& comparison);

}  // namespace raygauge
