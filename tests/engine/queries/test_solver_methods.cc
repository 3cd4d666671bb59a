// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_methods {
namespace {

DistanceResult solve(DistanceMethod method, const PointSet& A, const PointSet& Q) {
  DistanceOptions options;
  options.method = method;
  options.tolerance = 1e-9;
  return DistanceSolver(options).solve(A, Q);
}

void expect_agreement(int n, int N, Random& random) {
  Eigen::MatrixXd a = sphere_points(n, N, random);
  a.colwise() += 3 * sphere_points(n, 1, random).col(0);
  const PointSet A(a);
  const PointSet Q(sphere_points(n, N, random));
  const DistanceResult column_generation = solve(DistanceMethod::column_generation, A, Q);
  const DistanceResult published = solve(DistanceMethod::zheng_yamane, A, Q);
  RC_ASSERT(column_generation.status == published.status);
  RC_ASSERT(column_generation.lower <= published.upper);
  RC_ASSERT(published.lower <= column_generation.upper);
  if (column_generation.status == DistanceStatus::optimal)
    RC_ASSERT(published.upper - published.lower <= 1e-9 * published.upper);
}

RC_GTEST_PROP(Methods, AgreeWithinTheirBoundsInEveryDimension, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const int n = *rc::gen::inRange(2, 21);
  expect_agreement(n, *rc::gen::inRange(4 * n, 400), random);
}

RC_GTEST_PROP(Methods, AgreeWhereQMayMissTheOrigin, ()) {
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  const int n = *rc::gen::inRange(2, 9);
  expect_agreement(n, *rc::gen::inRange(1, 3 * n), random);
}

TEST(ZhengYamane, FindsOutAtOnceThatFewPointsOfManyDimensionsDoNotReach) {
  Random random(18);
  const int n = 160;
  Eigen::MatrixXd a = sphere_points(n, n + 2, random);
  a.colwise() += 3 * sphere_points(n, 1, random).col(0);
  const DistanceResult result =
      solve(DistanceMethod::zheng_yamane, PointSet(a), PointSet(sphere_points(n, n + 2, random)));
  EXPECT_EQ(result.status, DistanceStatus::unreachable);
  EXPECT_LT(result.counters.pivots, 5 * n);
}

TEST(ZhengYamane, AnswersWhereFewPointsOfManyDimensionsReach) {
  Random random(18);
  const int n = 160;
  Eigen::MatrixXd a = sphere_points(n, n + 2, random);
  a.colwise() += 3 * sphere_points(n, 1, random).col(0);
  Eigen::MatrixXd corners(n, 2 * n);
  corners << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  const PointSet A(a), Q(corners);
  const DistanceResult published = solve(DistanceMethod::zheng_yamane, A, Q);
  const DistanceResult columns = solve(DistanceMethod::column_generation, A, Q);
  EXPECT_EQ(published.status, DistanceStatus::optimal);
  EXPECT_LE(published.lower, columns.upper);
  EXPECT_LE(columns.lower, published.upper);
}

}  // namespace
}  // namespace raygauge::test_solver_methods
