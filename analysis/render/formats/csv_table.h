// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/render/table.h"

namespace raygauge {

/// RFC 4180, lines ending in LF: one header line (the header's lines joined by blanks), then the rows,
/// numbers in full. Title and notes are left out.
std::string csv_table(const Table& table);

}  // namespace raygauge
