// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_ladder.h"

#include <gtest/gtest.h>

#include "scene/simulation/friction_passes.h"
#include "scene/simulation/tuning.h"
#include "tests/scene/simulation/small_islands.h"

namespace raygauge::test_friction_ladder {
namespace {

// Of which passes alone leave one of twelve.
TEST(FrictionLadder, heaps_with_much_friction_are_solved) {
  small_islands::Random random(3);
  int by_passes = 0, by_all = 0;
  constexpr int kTrials = 200;
  for (int trial = 0; trial < kTrials; ++trial) {
    const FrictionIsland island = small_islands::heap(30, 60, 0.9, random);
    const double bound = island.bound_of_W();
    Eigen::VectorXd r = small_islands::zeros(island), passes = r;
    by_passes += pass_over_friction(island, bound, passes) <= kSolvedFriction ? 1 : 0;
    const double residual = solve_friction(island, nullptr, r);
    EXPECT_EQ(residual, island_residual(island, bound, r));
    by_all += residual <= kSolvedFriction ? 1 : 0;
  }
  EXPECT_LE(by_passes, kTrials * 19 / 20);
  EXPECT_EQ(by_all, kTrials);
}

// From where rough answers end, to rounding.
TEST(FrictionLadder, many_contacts_are_solved_roughly_and_from_there_to_the_end) {
  small_islands::Random random(4);
  for (int trial = 0; trial < 10; ++trial) {
    const FrictionIsland island =
        small_islands::heap(80, static_cast<int>(tuned::kManyContacts) + 60, 0.5, random);
    const double bound = island.bound_of_W();
    Eigen::VectorXd r = small_islands::zeros(island);
    const double rough = solve_friction(island, nullptr, r, true);
    EXPECT_EQ(rough, island_residual(island, bound, r));
    EXPECT_LE(rough, kMostRough);
    EXPECT_GT(rough, kPassedFriction);
    EXPECT_LE(solve_friction(island, nullptr, r), enough_friction(island.contacts.size(), false));
  }
}

}  // namespace
}  // namespace raygauge::test_friction_ladder
