// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// The share of wrong answers about two bodies against the median time of a solve, a panel for each place and
/// tolerance, a point for each method. Without records of the generator `bodies`: wrong_share().
Drawing wrong_share_figure(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
