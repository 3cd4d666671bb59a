// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "baselines/exact_columns.h"

namespace raygauge {

/// Columns that are probably basic at the optimum of the linear program of Example 2: the structural columns
/// of the basis at which a plain revised simplex in double precision stops, for whatever reason. A guess that
/// saves exact pivots; nothing relies on it.
std::vector<std::ptrdiff_t> float_start(const ExactColumns& columns,
                                        std::chrono::steady_clock::time_point deadline);

}  // namespace raygauge
