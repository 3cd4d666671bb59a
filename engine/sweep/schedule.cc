// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/schedule.h"

#include <algorithm>

#include "engine/sweep/seeded_order.h"

namespace raygauge {
namespace {

/// Sets the order of cells apart from the orders inside cells, whose streams are cell indices.
constexpr std::uint64_t kScheduleStream = ~std::uint64_t{0};

}  // namespace

double expected_cost(const Cell& cell) noexcept {
  return static_cast<double>(cell.n) * static_cast<double>(cell.N);
}

std::vector<Cell> longest_first(std::vector<Cell> cells, bool shuffle, std::uint64_t seed) {
  if (shuffle) {
    std::vector<Cell> shuffled;
    shuffled.reserve(cells.size());
    for (const std::size_t i : seeded_order(cells.size(), seed, kScheduleStream))
      shuffled.push_back(cells[i]);
    cells = std::move(shuffled);
  }
  std::stable_sort(cells.begin(), cells.end(),
                   [](const Cell& a, const Cell& b) { return expected_cost(a) > expected_cost(b); });
  return cells;
}

}  // namespace raygauge
