// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "analysis/studies/report.h"

namespace raygauge::report {

/// The picture that the page begins with: which method is fastest where, by how much, and where answers
/// disagree. Its rows and columns are the two of n, N, tolerance and problem that spread the cells the most;
/// what stands in one place is averaged (geometric mean of the times over the fastest in each cell). Nothing
/// where fewer than two methods were run, or nothing was solved.
std::optional<HeatMap> fastest_picture(const Input& input);

}  // namespace raygauge::report
