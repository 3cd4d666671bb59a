// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/table.h"
#include "analysis/studies/table3/table3.h"

namespace raygauge {

/// For reading: for each method a table in the paper's layout (rows n, columns N, median milliseconds, the
/// ratio in parentheses, the paper's own below), then a summary with the verdict.
std::vector<Table> table3_tables(const Table3& table3);

/// For CSV: one row a method and cell.
Table table3_long_table(const Table3& table3);

}  // namespace raygauge
