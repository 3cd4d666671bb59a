// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/sweep/experiment.h"

namespace raygauge {

/// Expected work of a cell in arbitrary units: n·N, the numbers that one pass over a set reads.
double expected_cost(const Cell& cell) noexcept;

/// `cells` with the longest expected ones first, so that no thread is left alone with a long cell at the end.
/// Equals stand in the order of the grid, or with `shuffle` in an order that depends on `seed`.
std::vector<Cell> longest_first(std::vector<Cell> cells, bool shuffle, std::uint64_t seed);

}  // namespace raygauge
