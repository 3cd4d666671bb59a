// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/exact_simplex.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/kernels/kernel.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_exact_program {
namespace {

Eigen::MatrixXd cross_polytope(int n) {
  Eigen::MatrixXd points(n, 2 * n);
  points << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  return points;
}

struct Solved {
  ExactSimplex program;
  ExactSimplex::End end = ExactSimplex::End::stopped;
};

Solved solve(const Eigen::MatrixXd& points_A, const Eigen::MatrixXd& points_Q,
             const std::vector<std::int64_t>& start = {}) {
  const PointSet A(points_A);
  const PointSet Q(points_Q);
  Solved solved;
  const Stopwatch stopwatch;
  solved.end = solved.program.solve({&A, {}}, {&Q, {}}, start, stopwatch);
  return solved;
}

TEST(ExactSimplex, RoundsTheNormOfAPointToItsNeighbours) {
  const Eigen::Vector3d point(1, -0x1p-300, 7);
  const Solved solved = solve(point, cross_polytope(3));
  ASSERT_EQ(solved.end, ExactSimplex::End::solved);
  EXPECT_EQ(solved.program.distance().below, 8);
  EXPECT_EQ(solved.program.distance().above, std::nextafter(8.0, 9.0));
  EXPECT_EQ(solved.program.distance().nearest, 8);
}

TEST(ExactSimplex, ReachesTheSameAnswerFromAnyStart) {
  const Eigen::MatrixXd Q = cross_polytope(4);
  Eigen::MatrixXd A(4, 3);
  A << 1, 2, 3, 1, 1, 5, 1, -1, 0, 2, 1, 1;
  const double expected = solve(A, Q).program.distance().nearest;
  const std::vector<std::vector<std::int64_t>> starts = {
      {id_of_A(2), id_of_Q(0), id_of_Q(1), id_of_Q(2), id_of_Q(3)},
      {id_of_Q(0), id_of_Q(4), id_of_Q(1), id_of_Q(5), -1},
      {id_of_A(0), id_of_A(1), id_of_A(2)}};
  for (const auto& start : starts) {
    const Solved solved = solve(A, Q, start);
    EXPECT_EQ(solved.end, ExactSimplex::End::solved);
    EXPECT_EQ(solved.program.distance().nearest, expected);
  }
}

TEST(ExactSimplex, TellsContactFromARoundingErrorAwayFromIt) {
  const double above = 1 + std::numeric_limits<double>::epsilon();
  const double below = 1 - std::numeric_limits<double>::epsilon() / 2;
  for (const double height : {below, 1.0, above}) {
    Eigen::MatrixXd A(2, 3);
    A << height, height, 3, 1, -1, 0;
    const Solved solved = solve(A, cross_polytope(2));
    ASSERT_EQ(solved.end, ExactSimplex::End::solved);
    EXPECT_EQ(solved.program.distance().below, height);
    EXPECT_EQ(solved.program.distance().above, height);
  }
}

TEST(ExactSimplex, TellsTheOriginOnAFaceFromAFaceNearTheOrigin) {
  for (const double height : {0.0, 1e-300, std::numeric_limits<double>::denorm_min()}) {
    Eigen::MatrixXd A(3, 4);
    A << height, height, height, 1, 1, -1, 0, 0, 1. / 3, 1. / 3, -1, 0;
    const Solved solved = solve(A, cross_polytope(3));
    ASSERT_EQ(solved.end, ExactSimplex::End::solved);
    EXPECT_EQ(solved.program.distance().below, height);
    EXPECT_EQ(solved.program.distance().above, height);
  }
}

TEST(ExactSimplex, ProvesThatNothingReaches) {
  Eigen::MatrixXd flat(2, 2);
  flat << 1, -1, 0, 0;
  const Solved solved = solve(Eigen::Vector2d(3, 1e-300), flat);
  ASSERT_EQ(solved.end, ExactSimplex::End::unreachable);
  Eigen::Vector2d u;
  solved.program.normal(u.data());
  EXPECT_LT(u[1], 0);
  EXPECT_EQ(u[0], 0);
}

TEST(ExactSimplex, ReportsANormalAndAContactPoint) {
  Eigen::MatrixXd A(2, 3);
  A << 2, 4, 4, 0.5, -1, 3;
  const PointSet points_A(A);
  const PointSet points_Q(cross_polytope(2));
  ExactSimplex program;
  ASSERT_EQ(program.solve({&points_A, {}}, {&points_Q, {}}, {}, {}), ExactSimplex::End::solved);
  EXPECT_EQ(program.distance().nearest, 2.5);
  Eigen::Vector2d u;
  program.normal(u.data());
  Eigen::Vector2d contact;
  program.contact_point(contact.data());
  EXPECT_NEAR(-u.dot(contact), program.distance().nearest, 1e-15);
  EXPECT_NEAR((u.transpose() * A).maxCoeff(), -program.distance().nearest, 1e-15);
}

TEST(ExactSimplex, UsesOnlyTheChosenPoints) {
  Eigen::MatrixXd A(2, 2);
  A << 1, 5, 0, 0;
  const PointSet points_A(A);
  const PointSet points_Q(cross_polytope(2));
  const std::array<std::int64_t, 1> second = {1};
  ExactSimplex program;
  ASSERT_EQ(program.solve({&points_A, second}, {&points_Q, {}}, {}, {}), ExactSimplex::End::solved);
  EXPECT_EQ(program.distance().nearest, 5);
}

TEST(ExactSimplex, StopsWhenTheTimeIsUp) {
  Stopwatch stopwatch;
  stopwatch.start(0);
  const PointSet A(Eigen::MatrixXd::Constant(3, 1, 2));
  const PointSet Q(cross_polytope(3));
  ExactSimplex program;
  EXPECT_EQ(program.solve({&A, {}}, {&Q, {}}, {}, stopwatch), ExactSimplex::End::stopped);
}

TEST(ExactSimplex, IsNotBegunWhereItWouldTakeLongerThanTheLimit) {
  Random random(1);
  Eigen::MatrixXd a = sphere_points(100, 300, random);
  a.row(0).array() += 3;
  const PointSet A(a);
  const PointSet Q(sphere_points(100, 300, random));
  Stopwatch stopwatch;
  stopwatch.start(0.5);
  ExactSimplex program;
  EXPECT_EQ(program.solve({&A, {}}, {&Q, {}}, {}, stopwatch), ExactSimplex::End::too_long);
  EXPECT_LT(stopwatch.seconds(), 0.1);
}

// The expectation is for one basis alone; from no basis there are more changes to make, and the clock ends
// them.
TEST(ExactSimplex, EndsWithinTheTimeLimit) {
  const int n = 40;
  Random random(3);
  Eigen::MatrixXd a = sphere_points(n, 200, random);
  a.row(0).array() += 3;
  const PointSet A(a);
  const PointSet Q(sphere_points(n, 200, random));
  const double limit = 1.5 * ExactSimplex::expected_seconds(n, 60);
  Stopwatch stopwatch;
  stopwatch.start(limit);
  ExactSimplex program;
  EXPECT_EQ(program.solve({&A, {}}, {&Q, {}}, {}, stopwatch), ExactSimplex::End::stopped);
  EXPECT_LE(stopwatch.seconds(), 1.2 * limit + 0.1);
}

}  // namespace
}  // namespace raygauge::test_exact_program
