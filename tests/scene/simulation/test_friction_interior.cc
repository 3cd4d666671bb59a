// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_interior.h"

#include <gtest/gtest.h>

#include "scene/simulation/friction_newton.h"
#include "tests/scene/simulation/small_islands.h"

namespace raygauge::test_friction_interior {
namespace {

double solve(const FrictionIsland& island, double enough, Eigen::VectorXd& r) {
  return IslandInterior(island, island.bound_of_W()).solve(enough, r);
}

TEST(FrictionInterior, one_contact_sticks_slides_or_opens_as_coulomb_says) {
  const auto expect = [](const Eigen::Vector3d& q, double mu, const Eigen::Vector3d& wanted) {
    const FrictionIsland island = small_islands::island_of(Eigen::MatrixXd::Identity(3, 6), q, mu);
    Eigen::VectorXd r;
    EXPECT_LE(solve(island, 1e-8, r), 1e-8);
    EXPECT_LE((r - wanted).norm(), 1e-7);
  };
  expect({-1, 0.3, 0}, 0.5, {1, -0.3, 0});
  expect({-1, 3, 0}, 0.5, {1, -0.5, 0});
  expect({-1, 3, 4}, 0.5, {1, -0.3, -0.4});
  expect({1, 3, 0}, 0.5, {0, 0, 0});
  expect({-1, 3, 0}, 0, {1, 0, 0});
}

// Of contacts that neither press nor part little is told; what is left is soon Newton's.
TEST(FrictionInterior, heaps_come_near_enough_for_newton) {
  small_islands::Random random(11);
  constexpr int kTrials = 60;
  int near = 0, solved = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const FrictionIsland island = small_islands::heap(30, 60, trial % 2 == 0 ? 0.5 : 0.9, random);
    Eigen::VectorXd r;
    const double residual = solve(island, 1e-9, r);
    EXPECT_EQ(residual, island_residual(island, island.bound_of_W(), r));
    near += residual <= 1e-3 ? 1 : 0;
    solved += IslandNewton(island, island.bound_of_W()).improve(100, 1e-9, r) <= 1e-9 ? 1 : 0;
  }
  EXPECT_GE(near, kTrials * 9 / 10);
  EXPECT_GE(solved, kTrials * 9 / 10);
}

}  // namespace
}  // namespace raygauge::test_friction_interior
