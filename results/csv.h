// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/sweep/record.h"

namespace raygauge {

/// Writes `records` as CSV: a header line of the column names of record_columns(), then one line a record.
/// Numbers have 17 significant digits (every double survives), infinities and NaN are `inf`, `-inf`, `nan`,
/// booleans `true` and `false`; texts are quoted after RFC 4180 where they need it; lines end in LF. The file
/// is replaced as a whole or not at all. Throws ResultsError.
void write_csv(const std::string& path, const std::vector<Record>& records);

}  // namespace raygauge
