// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/contact_lanes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scene/simulation/small_islands.h"

namespace raygauge::test_contact_lanes {
namespace {

double residual(const FrictionIsland& island, const IslandLanes& lanes, const Eigen::VectorXd& r) {
  const double s = step_of(island.bound_of_W());
  return std::sqrt(lanes.error(s, r)) / (s * island.size_of_q());
}

// An odd number of contacts, and an even one.
TEST(IslandLanes, residual_is_that_of_the_island) {
  small_islands::Random random(21);
  for (const int contacts : {1, 2, 31, 60}) {
    const FrictionIsland island = small_islands::heap(12, contacts, 0.6, random);
    IslandLanes lanes(island);
    Eigen::VectorXd r = small_islands::zeros(island);
    for (double& x : r) x = small_islands::some(random);
    lanes.reset(r);
    const double wanted = island_residual(island, island.bound_of_W(), r);
    EXPECT_NEAR(residual(island, lanes, r), wanted, 1e-12 * wanted);
    lanes.pass(r);
    const double after = island_residual(island, island.bound_of_W(), r);
    EXPECT_NEAR(residual(island, lanes, r), after, 1e-12 * (1 + after));
  }
}

TEST(IslandLanes, one_contact_is_solved_by_passes) {
  small_islands::Random random(22);
  for (const double mu : {0.0, 0.3, 2.0}) {
    for (int trial = 0; trial < 50; ++trial) {
      const FrictionIsland island = small_islands::heap(2, 1, mu, random);
      IslandLanes lanes(island);
      Eigen::VectorXd r = small_islands::zeros(island);
      for (int pass = 0; pass < 200; ++pass) lanes.pass(r);
      EXPECT_LE(island_residual(island, island.bound_of_W(), r), 1e-9) << mu;
    }
  }
}

TEST(IslandLanes, what_solves_the_island_stays) {
  small_islands::Random random(23);
  const FrictionIsland island = small_islands::heap(6, 8, 0.5, random);
  IslandLanes lanes(island);
  Eigen::VectorXd r = small_islands::zeros(island);
  for (int pass = 0; pass < 5000; ++pass) lanes.pass(r);
  ASSERT_LE(island_residual(island, island.bound_of_W(), r), 1e-12);
  const Eigen::VectorXd before = r;
  lanes.pass(r);
  EXPECT_LE((r - before).norm(), 1e-11 * (1 + r.norm()));
}

}  // namespace
}  // namespace raygauge::test_contact_lanes
