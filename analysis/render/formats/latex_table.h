// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/render/table.h"

namespace raygauge {

/// A table environment around a tabular, title as caption, notes in a footnote size paragraph below. Needs no
/// package; compiles with pdfLaTeX.
std::string latex_table(const Table& table);

}  // namespace raygauge
