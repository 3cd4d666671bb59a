// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_passes.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/scene/simulation/small_islands.h"

namespace raygauge::test_friction_passes {
namespace {

using small_islands::heap;
using small_islands::Random;
using small_islands::some;
using small_islands::zeros;

TEST(FrictionPasses, one_contact_sticks_slides_or_opens_as_coulomb_says) {
  FrictionIsland island;
  island.bodies = 1;
  IslandContact& contact = island.contacts.emplace_back();
  contact.a = 0;
  contact.A_a.topRows<3>().setIdentity();
  contact.mu = 0.5;
  const auto solved = [&island](const Eigen::Vector3d& q) {
    island.contacts.front().q = q;
    Eigen::VectorXd r = zeros(island);
    EXPECT_LE(pass_over_friction(island, island.bound_of_W(), r), 1e-10);
    return Eigen::Vector3d(r);
  };
  EXPECT_LE((solved({-1, 0.3, 0}) - Eigen::Vector3d(1, -0.3, 0)).norm(), 1e-9);
  EXPECT_LE((solved({-1, 3, 0}) - Eigen::Vector3d(1, -0.5, 0)).norm(), 1e-9);
  EXPECT_EQ(solved({1, 3, 0}).norm(), 0);
}

TEST(FrictionPasses, an_island_is_the_dense_problem_and_its_residual_is_not_below_that) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const FrictionIsland island = heap(4, 9, 0.5, random);
    const FrictionProblem dense = island.dense();
    Eigen::VectorXd r = zeros(island);
    for (Eigen::Index k = 0; k < r.size(); ++k) r[k] = some(random);
    const Eigen::VectorXd u = dense.W * r + dense.q;
    const IslandVelocities velocities(island, r);
    for (std::size_t c = 0; c < island.contacts.size(); ++c) {
      const auto at = 3 * static_cast<Eigen::Index>(c);
      EXPECT_LE((velocities.of(island.contacts[c]) - u.segment<3>(at)).norm(), 1e-12);
    }
    const double bound = island.bound_of_W();
    EXPECT_GE(bound * (1 + 1e-12), dense.W.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff());
    EXPECT_GE(island_residual(island, std::max(bound, dense.W.cwiseAbs().rowwise().sum().maxCoeff()), r),
              friction_residual(dense, r) * (1 - 1e-12));
  }
}

TEST(FrictionPasses, heaps_are_solved_and_what_is_returned_is_the_residual) {
  Random random(2);
  int solved = 0;
  constexpr int kTrials = 50;
  for (int trial = 0; trial < kTrials; ++trial) {
    const FrictionIsland island = heap(20, 30, trial % 2 == 0 ? 0.1 : 0, random);
    const double bound = island.bound_of_W();
    Eigen::VectorXd r = zeros(island);
    const double residual = pass_over_friction(island, bound, r);
    EXPECT_EQ(residual, island_residual(island, bound, r));
    solved += residual <= kSolvedFriction ? 1 : 0;
    for (Eigen::Index at = 0; at < r.size(); at += 3)
      EXPECT_LE(r.segment<2>(at + 1).norm(), island.contacts.front().mu * r[at] * (1 + 1e-12) + 1e-12);
    const Eigen::VectorXd before = r;
    EXPECT_LE(pass_over_friction(island, bound, r), residual);  // a solution is kept
    EXPECT_TRUE(residual > 1e-10 || r == before);
  }
  EXPECT_GE(solved, kTrials * 9 / 10);
}

TEST(FrictionPasses, impulses_that_are_worse_than_none_are_not_begun_with) {
  Random random(4);
  const FrictionIsland island = heap(20, 30, 0.1, random);
  const double bound = island.bound_of_W();
  Eigen::VectorXd from_none = zeros(island), from_huge = zeros(island);
  for (Eigen::Index k = 0; k < from_huge.size(); k += 3) from_huge[k] = 1e9;
  const double residual = pass_over_friction(island, bound, from_none);
  EXPECT_EQ(pass_over_friction(island, bound, from_huge), residual);
  EXPECT_TRUE(from_huge == from_none);
}

}  // namespace
}  // namespace raygauge::test_friction_passes
