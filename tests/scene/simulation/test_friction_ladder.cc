// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/friction_ladder.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "scene/simulation/friction_newton.h"

namespace raygauge::test_friction_ladder {
namespace {

// A ball of radius 1 and mass 1 at so many walls of a corner, each at right angles to the others, with gaps
// that ask for velocities of 1e-6: it cannot stick at two of them.
FrictionProblem ball_in_corner(Eigen::Index walls, std::mt19937& numbers) {
  constexpr double kInertia = 0.4;
  std::uniform_real_distribution<double> some(-1, 1);
  Eigen::MatrixXd J(3 * walls, 6);
  for (Eigen::Index wall = 0; wall < walls; ++wall) {
    const Eigen::Vector3d n = Eigen::Vector3d::Unit(wall), t = Eigen::Vector3d::Unit((wall + 1) % 3);
    Eigen::Matrix3d frame, arm;
    frame << n.transpose(), t.transpose(), n.cross(t).transpose();
    arm << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;  // spin -> velocity at -n
    J.middleRows<3>(3 * wall) << frame, frame * arm / std::sqrt(kInertia);
  }
  Eigen::VectorXd free(6);
  free << -1.5 + some(numbers), -1.5 + some(numbers), -1.5 + some(numbers), 0.2 * some(numbers),
      0.2 * some(numbers), 0.2 * some(numbers);
  FrictionProblem problem{J * J.transpose(), J * free,
                          std::vector<double>(static_cast<std::size_t>(walls), 0.5)};
  for (Eigen::Index wall = 0; wall < walls; ++wall) problem.q[3 * wall] += 1e-6 * some(numbers);
  return problem;
}

TEST(FrictionLadder, a_ball_that_cannot_stick_at_two_walls_is_solved_more_often_by_softer_ones) {
  std::mt19937 numbers(5);
  constexpr int kTrials = 300;
  int by_newton = 0, by_softer = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const FrictionProblem problem = ball_in_corner(2 + trial % 2, numbers);
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(problem.q.size());
    Eigen::VectorXd r = nothing;
    const double before = improve_friction(problem, r, 0);
    const double after = stiffen_contacts(problem, nothing, before, r);
    EXPECT_LE(after, before);
    EXPECT_EQ(after, friction_residual(problem, r));
    by_newton += before <= 1e-9 ? 1 : 0;
    by_softer += after <= 1e-9 ? 1 : 0;
  }
  EXPECT_GE(by_softer, by_newton + kTrials / 10);
}

}  // namespace
}  // namespace raygauge::test_friction_ladder
