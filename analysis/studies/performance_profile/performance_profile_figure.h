// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Dolan and Moré's profiles (performance_profiles()) over all records that pass the filter, generators and
/// tolerances together; the time ratio is logarithmic. Needs two methods.
Drawing performance_profile_figure(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
