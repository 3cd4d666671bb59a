// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Time in per cent of the best baseline's (ratio of the medians, CellRatio) over n and N: a panel for each
/// method, the number in each cell, colour on a logarithmic scale. Needs one generator, one tolerance and a
/// baseline.
Drawing ratio_heatmap(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
