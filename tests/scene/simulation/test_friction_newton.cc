// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_newton.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace raygauge::test_friction_newton {
namespace {

TEST(FrictionNewton, one_contact_sticks_slides_or_opens_as_coulomb_says) {
  FrictionProblem problem{Eigen::Matrix3d::Identity(), Eigen::Vector3d(-1, 0.3, 0), {0.5}};
  const auto solved = [&problem] {
    Eigen::VectorXd r = Eigen::VectorXd::Zero(3);
    EXPECT_LE(improve_friction(problem, r), 1e-14);
    return Eigen::Vector3d(r);
  };
  EXPECT_LE((solved() - Eigen::Vector3d(1, -0.3, 0)).norm(), 1e-14);
  problem.q[1] = 3;
  EXPECT_LE((solved() - Eigen::Vector3d(1, -0.5, 0)).norm(), 1e-14);
  problem.q[0] = 1;
  EXPECT_LE(solved().norm(), 1e-14);
}

// Four feet of a box that slides and turns on a floor: W has the rank 6 of 12.
TEST(FrictionNewton, four_feet_that_share_a_load_are_solved_to_rounding) {
  std::mt19937 numbers(7);
  std::uniform_real_distribution<double> some(-1, 1);
  int solved = 0;
  constexpr int kTrials = 50;
  for (int trial = 0; trial < kTrials; ++trial) {
    Eigen::MatrixXd J(12, 6);
    for (int foot = 0; foot < 4; ++foot) {
      const double x = foot % 2 == 0 ? 0.3 : -0.3, y = foot < 2 ? 0.2 : -0.2, z = -0.1;
      J.middleRows<3>(static_cast<Eigen::Index>(3) * foot) << 0, 0, 1, y, -x, 0, 1, 0, 0, 0, z, -y, 0, 1, 0,
          -z, 0, x;
    }
    Eigen::VectorXd free(6);
    free << some(numbers), some(numbers), -0.1, 0, 0, some(numbers);
    FrictionProblem problem{J * J.transpose(), J * free, std::vector<double>(4, 0.5)};
    Eigen::VectorXd r = Eigen::VectorXd::Zero(12);
    const double before = friction_residual(problem, r);
    const double after = improve_friction(problem, r);
    EXPECT_LE(after, before);
    EXPECT_EQ(after, friction_residual(problem, r));
    solved += after <= 1e-11 ? 1 : 0;
  }
  EXPECT_GE(solved, kTrials * 9 / 10);
}

}  // namespace
}  // namespace raygauge::test_friction_newton
