// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/seeded_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace raygauge::test_seeded_order {
namespace {

TEST(SeededOrder, IsAPermutation) {
  for (const std::size_t count : {0u, 1u, 2u, 5u, 100u}) {
    std::vector<std::size_t> order = seeded_order(count, 3, 4);
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> expected(count);
    std::iota(expected.begin(), expected.end(), std::size_t{0});
    EXPECT_EQ(order, expected);
  }
}

TEST(SeededOrder, DependsOnSeedAndStreamAlone) {
  EXPECT_EQ(seeded_order(50, 1, 2), seeded_order(50, 1, 2));
  EXPECT_NE(seeded_order(50, 1, 2), seeded_order(50, 2, 2));
  EXPECT_NE(seeded_order(50, 1, 2), seeded_order(50, 1, 3));
}

TEST(SeededOrder, PutsEveryElementEverywhere) {
  // 4000 draws of 4 elements: each position gets each element 1000 times, standard deviation 27.
  constexpr int kDraws = 4000;
  int hits[4][4] = {};
  for (int seed = 0; seed < kDraws; ++seed) {
    const auto order = seeded_order(4, static_cast<std::uint64_t>(seed), 0);
    for (std::size_t position = 0; position < 4; ++position) ++hits[position][order[position]];
  }
  for (const auto& row : hits) {
    for (const int count : row) EXPECT_NEAR(count, kDraws / 4, 5 * 27);
  }
}

}  // namespace
}  // namespace raygauge::test_seeded_order
