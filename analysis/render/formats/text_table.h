// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "analysis/render/table.h"

namespace raygauge {

/// Columns aligned with blanks: keys to the left, values to the right. A table wider than `width` (0: no
/// limit) is continued below, its keys repeated. With `color`, emphasis is shown by ANSI escapes.
std::string text_table(const Table& table, std::size_t width, bool color);

}  // namespace raygauge
