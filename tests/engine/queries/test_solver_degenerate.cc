// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_degenerate {
namespace {

// Optimal solutions in which weights vanish: no basis proves them nonnegative.
using Degenerate = BothMethods;
RAYGAUGE_BOTH_METHODS(Degenerate);

// Multiples of 1/4 outside every box below.
Vector corner(int n, Random& random) {
  Vector p = 0.25 * integer_points(n, 1, 40, random);
  p[0] += 13;
  return p;
}

TEST_P(Degenerate, BoxesAgainstCrossPolytopeAndCubeMatchTheClosedForm) {
  Random random(64);
  for (const int n : {1, 2, 3, 5, 8}) {
    const Vector c = corner(n, random);
    const Vector h = 0.25 * integer_points(n, 1, 8, random).cwiseAbs() + Vector::Constant(n, 0.25);
    const Eigen::MatrixXd box = (h.asDiagonal() * cube_vertices(n)).colwise() + c;
    const Vector outside = (c.cwiseAbs() - h).cwiseMax(0);
    expect_distance(outside.sum(), box, cross_polytope_vertices(n));
    expect_distance(outside.maxCoeff(), box, cube_vertices(n));
  }
}

TEST_P(Degenerate, LatticesAgainstTheirOwnShiftMatchTheClosedForm) {
  for (const int n : {1, 2, 3, 4}) {
    // [1/2, 9/2]^n against [-9/4, 7/4]^n: the corner (1/2, …) is reached at (1/2) / (7/4).
    const Eigen::MatrixXd lattice = lattice_points(n, 4).array() + 0.5;
    const DistanceResult result = solve(lattice, lattice.array() - 2.75, 1e-12);
    EXPECT_EQ(result.status, DistanceStatus::optimal);
    EXPECT_LE(result.lower, 2.0 / 7 * (1 + 1e-15));
    EXPECT_GE(result.upper, 2.0 / 7 * (1 - 1e-15));
  }
}

TEST_P(Degenerate, FacesNearTheOriginKeepHonestBounds) {
  for (const double delta : {1e-1, 1e-3, 1e-8, 1e-20, 1e-100, 1e-300}) {
    Eigen::MatrixXd face = cube_vertices(3);
    face.row(0).setConstant(delta);
    const DistanceResult result = solve(face, cube_vertices(3), 1e-6);
    EXPECT_LE(result.lower, delta);
    EXPECT_GE(result.upper, delta);
    EXPECT_LE(result.upper - result.lower, 1e-6 * result.upper + 1e-14) << "delta = " << delta;
    if (delta >= 1e-8) {
      EXPECT_EQ(result.status, DistanceStatus::optimal) << "delta = " << delta;
    }
  }
}

}  // namespace
}  // namespace raygauge::test_solver_degenerate
