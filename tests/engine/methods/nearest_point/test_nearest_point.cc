// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/nearest_point/nearest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

using Points = std::shared_ptr<const PointSet>;

// Normal points about `offset` on the first axis.
Points cloud(int n, int N, double offset, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points = Eigen::MatrixXd::NullaryExpr(n, N, [&] { return normal(random); });
  points.row(0).array() += offset;
  return std::make_shared<PointSet>(points);
}

Ball unit_ball(int n) { return {Vector::Zero(n), 1.0}; }

DistanceResult euclidean(const ConvexSet& A, double tolerance,
                         DistanceMethod method = DistanceMethod::automatic) {
  DistanceOptions options;
  options.method = method;
  options.tolerance = tolerance;
  return DistanceSolver(options).solve(A, unit_ball(A.dimension()));
}

void expect_optimal(const DistanceResult& result, double tolerance) {
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.lower, result.distance);
  EXPECT_LE(result.distance, result.upper);
  EXPECT_LE(result.upper - result.lower, tolerance * result.upper);
}

TEST(NearestPoint, IsWhatAutomaticTakesForPolytopesAndABallAboutTheOrigin) {
  const Points A = cloud(4, 20, 9, 1);
  const auto ball = std::make_shared<Ball>(Vector::Zero(4), 2.0);
  const Ball off(Vector::Unit(4, 0), 2.0);
  EXPECT_TRUE(NearestPoint::suits(MinkowskiDifference(A, A), *ball));
  EXPECT_TRUE(NearestPoint::suits(*A, *ball));
  EXPECT_FALSE(NearestPoint::suits(MinkowskiDifference(A, ball), *ball));
  EXPECT_FALSE(NearestPoint::suits(*A, off));
  EXPECT_FALSE(NearestPoint::suits(*A, *A));
  EXPECT_EQ(method_for(*ball), DistanceMethod::newton);
  EXPECT_EQ(method_for(*A), DistanceMethod::column_generation);
}

TEST(NearestPoint, OfAFaceOfASimplexIsItsCentre) {
  for (const int n : {2, 5, 20, 100, 150}) {
    const PointSet simplex(Eigen::MatrixXd::Identity(n, n));
    const DistanceResult result = euclidean(simplex, 1e-12);
    expect_optimal(result, 1e-12);
    EXPECT_NEAR(result.distance, 1 / std::sqrt(n), 1e-12) << n;
  }
}

TEST(NearestPoint, OfBoxesIsTheGapBetweenThem) {
  const int n = 12;
  const auto near = std::make_shared<Box>(-Vector::Ones(n), Vector::Ones(n));
  Vector lower = -Vector::Ones(n);
  lower.head(2) << 4, 5;  // gaps of 3 and 4
  const auto far = std::make_shared<Box>(lower, lower + 2 * Vector::Ones(n));
  const DistanceResult result = euclidean(MinkowskiDifference(far, near), 1e-9);
  expect_optimal(result, 1e-9);
  EXPECT_NEAR(result.distance, 5, 1e-8);
}

TEST(NearestPoint, AgreesWithColumnGenerationOnRandomClouds) {
  for (const int n : {2, 3, 5, 9, 17, 30}) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const MinkowskiDifference A(cloud(n, 3 * n, 6, seed), cloud(n, 2 * n + 1, 0, seed + 100));
      const DistanceResult wolfe = euclidean(A, 1e-9);
      const DistanceResult columns = euclidean(A, 1e-6, DistanceMethod::column_generation);
      if (columns.status != DistanceStatus::optimal) continue;
      expect_optimal(wolfe, 1e-9);
      EXPECT_LE(wolfe.lower, columns.upper) << n << " " << seed;
      EXPECT_LE(columns.lower, wolfe.upper) << n << " " << seed;
    }
  }
}

TEST(NearestPoint, IsProvenToTwelveDigitsInManyDimensions) {
  for (const int n : {50, 100}) {
    const MinkowskiDifference A(cloud(n, 3 * n, 12, 3), cloud(n, 4 * n, 0, 4));
    const DistanceResult result = euclidean(A, 1e-12);
    expect_optimal(result, 1e-12);
    EXPECT_LT(result.counters.pivots, 20 * n) << "column generation took over";
  }
}

TEST(NearestPoint, MeetsPointsThatAreFarAwayFlatOrDouble) {
  Eigen::MatrixXd flat(3, 6);
  flat << 1, 2, 1, 2, 1, 2, 0, 0, 3, 3, 0, 0, 5, 5, 5, 5, 5, 5;
  const auto S = std::make_shared<PointSet>(flat);
  const auto T = std::make_shared<PointSet>((-flat).eval());
  expect_optimal(euclidean(*S, 1e-12), 1e-12);
  EXPECT_NEAR(euclidean(*S, 1e-12).distance, std::sqrt(26.0), 1e-10);
  EXPECT_NEAR(euclidean(MinkowskiDifference(S, T), 1e-12).distance, std::sqrt(104.0), 1e-10);
  const auto shifted = [&](double by) {
    return std::make_shared<PointSet>((flat.array() + by).matrix().eval());
  };
  Eigen::MatrixXd lifted = flat.array() + 1e5;
  lifted.row(2).array() += 7;
  const MinkowskiDifference far(std::make_shared<PointSet>(lifted), shifted(1e5));
  expect_optimal(euclidean(far, 1e-9), 1e-9);
  EXPECT_NEAR(euclidean(far, 1e-9).distance, 7, 1e-8);
}

TEST(NearestPoint, OfSetsThatMeetIsTheOrigin) {
  for (const int n : {2, 6, 12}) {
    const MinkowskiDifference A(cloud(n, 6 * n, 0.1, 7), cloud(n, 6 * n, 0, 8));
    EXPECT_EQ(euclidean(A, 1e-6).status, DistanceStatus::contains_origin) << n;
  }
}

TEST(NearestPoint, ScalesWithTheRadiusAndGivesTheNormal) {
  const Points A = cloud(7, 40, 8, 11);
  const double distance = euclidean(*A, 1e-10).distance;
  const DistanceResult result = DistanceSolver().solve(*A, Ball(Vector::Zero(7), 4.0), Effects::witness);
  EXPECT_NEAR(result.distance, distance / 4, 1e-6 * distance);
  EXPECT_NEAR(result.normal.norm(), 0.25, 1e-12);
  EXPECT_NEAR(result.contact_point.norm(), distance, 1e-6 * distance);
  EXPECT_NEAR(-A->support_function(result.normal), result.distance, 1e-6 * result.distance);
}

TEST(NearestPoint, GivesTheClosestPointsOfTwoObjects) {
  const int n = 20;
  const Points A1 = cloud(n, 60, 0, 1), A2 = cloud(n, 50, 9, 2);
  ObjectDistanceSolver solver;
  const ObjectDistance& result = solver.solve(*A1, *A2, unit_ball(n), ObjectEffects::closest_points);
  expect_optimal(result.distance, 1e-6);
  const Vector between = result.closest_point_2 - result.closest_point_1;
  EXPECT_NEAR(between.norm(), result.distance.distance, 1e-6 * between.norm());
  // Each is the point of its set nearest to the other.
  EXPECT_NEAR(between.dot(result.closest_point_1), A1->support_function(between), 1e-5);
  EXPECT_NEAR(-between.dot(result.closest_point_2), A2->support_function(-between), 1e-5);
}

TEST(NearestPoint, LooksAtASampleOfLargeSetsFirst) {
  const MinkowskiDifference A(cloud(10, 30000, 12, 5), cloud(10, 40000, 0, 6));
  const DistanceResult result = euclidean(A, 1e-6);
  expect_optimal(result, 1e-6);
  EXPECT_LT(result.counters.support_queries, 20);
}

TEST(NearestPoint, EndsAtATimeLimitWithItsBounds) {
  const MinkowskiDifference A(cloud(150, 2000, 14, 1), cloud(150, 2000, 0, 2));
  DistanceOptions options;
  options.time_limit = 0;
  const DistanceResult result = DistanceSolver(options).solve(A, unit_ball(150));
  EXPECT_EQ(result.status, DistanceStatus::time_limit);
  EXPECT_LE(result.lower, result.upper);
  EXPECT_LT(result.upper, 100);
}

TEST(NearestPoint, IsTheSameForARepeatedSolve) {
  const MinkowskiDifference A(cloud(25, 80, 8, 1), cloud(25, 90, 0, 2));
  const MinkowskiDifference B(cloud(40, 300, 8, 3), cloud(40, 90, 0, 4));
  DistanceSolver solver;
  const double first = solver.solve(A, unit_ball(25)).distance;
  solver.solve(B, unit_ball(40));
  EXPECT_EQ(solver.solve(A, unit_ball(25)).distance, first);
}

}  // namespace
}  // namespace raygauge
