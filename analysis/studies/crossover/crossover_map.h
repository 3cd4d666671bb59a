// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// The winner of each cell (cell_winners()) over n and N: its colour and letter, and how many times longer
/// the second takes on the same instances; "?" where the 95 % interval of that includes 1. Needs one
/// generator and tolerance, two methods.
Drawing crossover_figure(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
