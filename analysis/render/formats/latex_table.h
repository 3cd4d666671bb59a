// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/render/table.h"

namespace raygauge {

/// `text` so that LaTeX sets it as it stands: its special characters escaped, Greek letters and mathematical
/// signs (ε, µ, ≤, …) as mathematics.
std::string latex_escaped(const std::string& text);

/// A table environment around a tabular, title as caption, notes in a footnote size paragraph below. Needs no
/// package; compiles with pdfLaTeX.
std::string latex_table(const Table& table);

}  // namespace raygauge
