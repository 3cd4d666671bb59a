// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Largest true_error() of each method against the parameter that makes a family harder, both logarithmic, a
/// panel for each family that has one. Errors below 1e-17 stand at "0", those above 100 and infinite ones at
/// "∞", as does an infinite parameter. A method that came to no answer has no point there. Tolerances have
/// panels of their own. Throws FigureNeedsError.
Drawing true_error_figure(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
