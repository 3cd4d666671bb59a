// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Median time of a solve against the number of points, both logarithmic: a panel for each n, a curve for
/// each method, with 95 % intervals of the medians as bars. Records that disagree are left out; points where
/// the median solve is unsolved are not drawn. Needs one generator, one tolerance and two values of N.
Drawing time_vs_N(const std::vector<Record>& records, const FigureOptions& options);

/// The same against n, a panel for each N.
Drawing time_vs_dimension(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
