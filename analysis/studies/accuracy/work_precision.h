// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// `work_precision`: what accuracy costs. For each generator, n and N two panels, side by side where the
/// figure is wide: the relative error that a method reached, and the relative gap that was proven, means over
/// all solves, against the median time; a point for each tolerance, joined from the loosest to the tightest.
/// Where a curve goes on to the right without going down, the method no longer gets better. Errors below
/// 1e-17 stand at "0"; a gap where some solve has no bounds stands at "∞". Throws FigureNeedsError without
/// two tolerances and known truths.
Drawing work_precision(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
