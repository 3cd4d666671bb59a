// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Many dimensions: cubes and cross-polytopes, whose optimal bases are degenerate, smooth sets and their sums,
// and few points, which no multiple of Q may reach.
#include <gtest/gtest.h>

#include <memory>

#include "raygauge/sets/box.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_solver_high_dimension {
namespace {

using HighDimension = BothMethods;
RAYGAUGE_BOTH_METHODS(HighDimension);

Eigen::MatrixXd cross_polytope(int n) {
  Eigen::MatrixXd corners(n, 2 * n);
  corners << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  return corners;
}

Eigen::MatrixXd cube(int n) {
  return Eigen::MatrixXd::NullaryExpr(n, Eigen::Index{1} << n, [](Eigen::Index k, Eigen::Index i) {
    return ((i >> k) & 1) != 0 ? 1.0 : -1.0;
  });
}

Vector integer_center(int n, int bound, unsigned seed) {
  Random random(seed);
  return integer_points(n, 1, bound, random).col(0);
}

// A = c + r K and Q = K: d = gauge_K(c) - r, here in integers.
TEST_P(HighDimension, CrossPolytopesAreAtTheirDistance) {
  for (const int n : {12, 100}) {
    const Vector c = integer_center(n, 3, 1);
    const Eigen::MatrixXd Q = cross_polytope(n);
    expect_distance(c.lpNorm<1>() - 2, (2 * Q).colwise() + c, Q, 1e-9);
  }
}

TEST(HighDimensionOf500, CrossPolytopesAreAtTheirDistance) {
  const int n = 500;
  const Vector c = integer_center(n, 3, 2);
  const Eigen::MatrixXd Q = cross_polytope(n);
  DistanceOptions options;
  options.time_limit = 100;
  const DistanceResult result = DistanceSolver(options).solve(PointSet((2 * Q).colwise() + c), PointSet(Q));
  const double truth = c.lpNorm<1>() - 2;
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.lower, truth);
  EXPECT_GE(result.upper, truth);
}

TEST_P(HighDimension, CubesAreAtTheirDistance) {
  const int n = 12;
  const Vector c = integer_center(n, 9, 3);
  const Eigen::MatrixXd Q = cube(n);
  expect_distance(c.lpNorm<Eigen::Infinity>() - 2, (2 * Q).colwise() + c, Q, 1e-9);
}

// By support mappings, of which a cube has one answer for a whole orthant.
TEST(HighDimensionOfBoxes, CubesAsBoxesAreAtTheirDistance) {
  const int n = 100;
  const Vector c = integer_center(n, 9, 4);
  const Vector one = Vector::Ones(n);
  const DistanceResult result = DistanceSolver().solve(Box(c - 2 * one, c + 2 * one), Box(-one, one));
  const double truth = c.lpNorm<Eigen::Infinity>() - 2;
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.lower, truth);
  EXPECT_GE(result.upper, truth);
}

// A = c - r K, Q = K, as above; gauges of ellipsoids and p-norm balls in closed form.
class SmoothSets : public ::testing::TestWithParam<int> {
 protected:
  static void expect_distance(double truth, const ConvexSet& A, const ConvexSet& Q) {
    DistanceOptions options;
    options.method = DistanceMethod::newton;
    options.tolerance = 1e-9;
    options.time_limit = 60;
    const DistanceResult result = DistanceSolver(options).solve(A, Q);
    constexpr double kRounding = 1e-12;  // of the truth
    EXPECT_EQ(result.status, DistanceStatus::optimal) << to_string(result.status);
    EXPECT_LE(result.lower, truth * (1 + kRounding));
    EXPECT_GE(result.upper, truth * (1 - kRounding));
  }
};

INSTANTIATE_TEST_SUITE_P(Dimensions, SmoothSets, ::testing::Values(12, 50, 200));

TEST_P(SmoothSets, EllipsoidsAreAtTheirDistance) {
  const int n = GetParam();
  const Vector axes = Vector::LinSpaced(n, 1, 4);
  const Eigen::MatrixXd factor = axes.asDiagonal();
  const Vector c = integer_center(n, 9, 5);
  const double gauge = c.cwiseQuotient(axes).norm();
  expect_distance(gauge - 0.5, Ellipsoid(c, 0.5 * factor), Ellipsoid(Vector::Zero(n), factor));
}

TEST_P(SmoothSets, PNormBallsAreAtTheirDistance) {
  const int n = GetParam();
  const Vector c = integer_center(n, 9, 6);
  const Vector one = Vector::Ones(n);
  expect_distance(c.lpNorm<4>() - 0.5, PNormBall(c, 0.5 * one, 4), PNormBall(Vector::Zero(n), one, 4));
}

TEST_P(SmoothSets, SumsOfEllipsoidsAreAtTheirDistance) {
  const int n = GetParam();
  const Vector axes = Vector::LinSpaced(n, 1, 4);
  const Eigen::MatrixXd factor = axes.asDiagonal();
  const Vector c = integer_center(n, 9, 7);
  const Vector zero = Vector::Zero(n);
  const MinkowskiSum A(std::make_shared<Ellipsoid>(c, 0.25 * factor),
                       std::make_shared<Ellipsoid>(zero, 0.25 * factor));
  const MinkowskiSum Q(std::make_shared<Ellipsoid>(zero, 0.5 * factor),
                       std::make_shared<Ellipsoid>(zero, 0.5 * factor));
  expect_distance(c.cwiseQuotient(axes).norm() - 0.5, A, Q);
}

// The normal is a Farkas direction: u·a < 0 < u·q for all points.
TEST_P(HighDimension, FewPointsAreProvenUnreachable) {
  for (const int N : {202, 300}) {
    const int n = 200;
    Random random(static_cast<unsigned>(N));
    Eigen::MatrixXd a = sphere_points(n, N, random);
    a.colwise() += 3 * sphere_points(n, 1, random).col(0);
    const Eigen::MatrixXd q = sphere_points(n, N, random);
    const DistanceResult result = solve(a, q);
    ASSERT_EQ(result.status, DistanceStatus::unreachable) << N;
    EXPECT_LT((result.normal.transpose() * a).maxCoeff(), 0) << N;
    EXPECT_GT((result.normal.transpose() * q).minCoeff(), -1e-15) << N;
    EXPECT_EQ(result.counters.exact_pivots, 0) << N;
  }
}

// This size once ran into time limits of seconds.
TEST_P(HighDimension, OneAndAHalfPointsADimensionEndInAProof) {
  const int n = 500;
  const int N = 750;
  Random random(18);
  Eigen::MatrixXd a = sphere_points(n, N, random);
  a.colwise() += 3 * sphere_points(n, 1, random).col(0);
  const DistanceResult result = solve(a, sphere_points(n, N, random));
  EXPECT_EQ(result.status, DistanceStatus::unreachable);
}

}  // namespace
}  // namespace raygauge::test_solver_high_dimension
