// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/render/table.h"

namespace raygauge {

/// A pipe table (GitHub's Markdown): title in bold above, notes as a list below.
std::string markdown_table(const Table& table);

}  // namespace raygauge
