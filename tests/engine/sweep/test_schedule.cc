// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/schedule.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace raygauge::test_schedule {
namespace {

/// Costs 20, 40, …, 100, each of them 8 times.
std::vector<Cell> forty_cells() {
  std::vector<Cell> cells;
  for (std::uint64_t i = 0; i < 40; ++i) cells.push_back({i, 0, 2, 10 * (1 + static_cast<int>(i % 5)), 1e-6});
  return cells;
}

std::vector<std::uint64_t> indices(const std::vector<Cell>& cells) {
  std::vector<std::uint64_t> result;
  for (const Cell& cell : cells) result.push_back(cell.index);
  return result;
}

TEST(Schedule, LongestCellsComeFirst) {
  for (const bool shuffle : {false, true}) {
    const std::vector<Cell> order = longest_first(forty_cells(), shuffle, 1);
    EXPECT_TRUE(std::is_sorted(order.begin(), order.end(), [](const Cell& a, const Cell& b) {
      return expected_cost(a) > expected_cost(b);
    }));
  }
}

TEST(Schedule, EqualsKeepTheOrderOfTheGridUnlessShuffled) {
  const std::vector<Cell> plain = longest_first(forty_cells(), false, 1);
  EXPECT_EQ(indices({plain.begin(), plain.begin() + 3}), (std::vector<std::uint64_t>{4, 9, 14}));
  EXPECT_NE(indices(longest_first(forty_cells(), true, 1)), indices(plain));
}

TEST(Schedule, ShufflingDependsOnTheSeedAndLosesNoCell) {
  const auto order = indices(longest_first(forty_cells(), true, 1));
  EXPECT_EQ(order, indices(longest_first(forty_cells(), true, 1)));
  EXPECT_NE(order, indices(longest_first(forty_cells(), true, 2)));
  EXPECT_TRUE(std::is_permutation(order.begin(), order.end(), indices(forty_cells()).begin()));
}

}  // namespace
}  // namespace raygauge::test_schedule
