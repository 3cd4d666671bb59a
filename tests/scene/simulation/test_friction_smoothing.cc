// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_smoothing.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "scene/simulation/friction_newton.h"
#include "tests/scene/simulation/small_islands.h"
#include "tests/scene/simulation/stuck_friction.h"

namespace raygauge::test_friction_smoothing {
namespace {

TEST(FrictionSmoothing, one_contact_sticks_slides_or_opens_as_coulomb_says) {
  const Eigen::Matrix3d W = Eigen::Matrix3d::Identity();
  const auto expect = [&W](const Eigen::Vector3d& q, double mu, const Eigen::Vector3d& wanted) {
    Eigen::VectorXd r = Eigen::VectorXd::Zero(3);
    EXPECT_LE(follow_smoothed_friction({W, q, {mu}}, 0.3, r), 1e-8);
    EXPECT_LE((r - wanted).norm(), 1e-8);
  };
  expect({-1, 0.3, 0}, 0.5, {1, -0.3, 0});
  expect({-1, 3, 0}, 0.5, {1, -0.5, 0});
  expect({-1, 3, 0}, 0, {1, 0, 0});
  expect({1, 3, 0}, 0.5, {0, 0, 0});
}

TEST(FrictionSmoothing, a_problem_on_which_newtons_method_cycles_is_solved) {
  const FrictionProblem problem = stuck_friction::problem();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> W(problem.W);
  const Eigen::VectorXd roots = W.eigenvalues().cwiseMax(0).cwiseSqrt();
  const FrictionIsland island =
      small_islands::island_of(W.eigenvectors() * roots.asDiagonal(), problem.q, 0.5);
  IslandNewton newton(island, island.bound_of_W());
  Eigen::VectorXd alone = Eigen::VectorXd::Zero(problem.q.size()), r = alone;
  EXPECT_GT(newton.improve(alone), 1e-8);
  follow_smoothed_friction(problem, 0.7, r);
  EXPECT_LE(newton.improve(r), 1e-12);
}

TEST(FrictionSmoothing, bodies_at_rest_need_no_impulse) {
  Eigen::VectorXd r = Eigen::VectorXd::Ones(3);
  EXPECT_EQ(follow_smoothed_friction({Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), {0.5}}, 0.3, r),
            0);
  EXPECT_TRUE(r.isZero(0));
}

}  // namespace
}  // namespace raygauge::test_friction_smoothing
