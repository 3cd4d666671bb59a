// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "raygauge/exceptions.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "raygauge/sets/pose.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_depth_solver {
namespace {

constexpr double kTolerance = 1e-6;
constexpr double kRounding = 1e-12;  // of what the tests compute themselves, for sets of size 1
constexpr double kInfinite = std::numeric_limits<double>::infinity();

DistanceOptions options(double tolerance = kTolerance) {
  DistanceOptions result;
  result.tolerance = tolerance;
  return result;
}

Ball euclidean(int n) { return {Vector::Zero(n), 1.0}; }

// point_2 is a multiple of the support point q of Q, between the bounds. 1e-6: a ray that grazes facets of
// the polytope.
void expect_point(const ObjectDepth& depth, const Vector& q) {
  ASSERT_EQ(depth.point_2.size(), q.size());
  const double along = depth.point_2.dot(q) / q.squaredNorm();
  EXPECT_LT((depth.point_2 - along * q).norm(), 1e-6 * q.norm());
  EXPECT_GE(along, depth.lower * (1 - 1e-9));
  EXPECT_LE(along, depth.upper * (1 + 1e-9));
}

// The interval holds `truth` and is as narrow as was asked for; normal and point say so too.
void expect_depth(const ConvexSet& D, const ConvexSet& Q, double truth, double tolerance = kTolerance) {
  DepthSolver solver(options(tolerance));
  const ObjectDepth& depth = solver.solve(D, Q);
  EXPECT_EQ(depth.status, DistanceStatus::optimal);
  EXPECT_LE(depth.lower, truth * (1 + kRounding));
  EXPECT_GE(depth.upper, truth * (1 - kRounding));
  EXPECT_LE(depth.upper - depth.lower, tolerance * depth.upper);
  ASSERT_EQ(depth.normal.size(), D.dimension());
  EXPECT_NEAR(Q.support_function(depth.normal), 1, 1e-9);
  EXPECT_NEAR(D.support_function(depth.normal), depth.upper, kRounding);
  expect_point(depth, Q.support_mapping(depth.normal));
}

class DepthInSpace : public ::testing::TestWithParam<int> {};

TEST_P(DepthInSpace, OfCubesAndCrossPolytopesHasAClosedForm) {
  const int n = GetParam();
  const PNormBall largest(Vector::Zero(n), Vector::Ones(n), kInfinite),
      sum(Vector::Zero(n), Vector::Ones(n), 1);
  const PointSet cross(cross_polytope_vertices(n)), cube(cube_vertices(n));
  expect_depth(cross, euclidean(n), 1 / std::sqrt(n));
  expect_depth(cross, largest, 1.0 / n);
  expect_depth(cross, sum, 1);
  expect_depth(cube, euclidean(n), 1);
  expect_depth(cube, sum, 1);
  expect_depth(PointSet(simplex_vertices(n)), euclidean(n), 1 / std::sqrt(n * n + n - 1.0));
}

TEST_P(DepthInSpace, OfCurvedSetsIsFoundOnAllSides) {
  const int n = GetParam();
  Vector center = Vector::Zero(n);
  center[n - 1] = 0.75;
  expect_depth(Ball(center, 1), euclidean(n), 0.25);
  Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(n, n);
  for (int k = 0; k < n; ++k) axes(k, k) = 1 + 0.5 * ((k + 2) % n);
  expect_depth(Ellipsoid(Vector::Zero(n), axes), euclidean(n), 1, 1e-2);
}

// Facets are known: the depth is the least distance of one, in any metric.
TEST_P(DepthInSpace, OfPolytopesByInequalitiesIsTheLeastOfTheirFacets) {
  const int n = GetParam();
  Random random(static_cast<std::uint64_t>(n));
  std::uniform_real_distribution<double> offset(0.5, 2);
  for (int attempt = 0; attempt < 10; ++attempt) {
    Eigen::MatrixXd G(2 * n + 8, n);
    G << cross_polytope_vertices(n).transpose(), gaussian_points(n, 8, random).transpose();
    const Vector g = Vector::NullaryExpr(G.rows(), [&] { return offset(random); });
    const HPolytope D(G, g);
    const Box Q(Vector::Constant(n, -0.5), Vector::LinSpaced(n, 0.25, 1));
    double of_ball = kInfinite, of_box = kInfinite;
    for (Eigen::Index i = 0; i < G.rows(); ++i) {
      of_ball = std::min(of_ball, g[i] / G.row(i).norm());
      of_box = std::min(of_box, g[i] / Q.support_function(G.row(i).transpose()));
    }
    expect_depth(D, euclidean(n), of_ball);
    expect_depth(D, Q, of_box);
  }
}

TEST_P(DepthInSpace, OfIntegerPointsIsBelowTheirHeightsInAllDirections) {
  const int n = GetParam();
  Random random(17);
  DepthSolver solver(options());
  for (int attempt = 0; attempt < 20; ++attempt) {
    const PointSet D(integer_points(n, 40, 2, random));
    const ObjectDepth& depth = solver.solve(D, euclidean(n));
    EXPECT_EQ(depth.status, DistanceStatus::optimal);
    for (int i = 0; i < 2000; ++i) {
      const Vector u = integer_points(n, 1, 3, random);
      if (u.norm() > 0) {
        EXPECT_LE(depth.lower, D.support_function(u) / u.norm() + kRounding);
      }
    }
    if (depth.upper > 0) {
      EXPECT_NEAR(D.support_function(depth.normal), depth.upper, kRounding);
    }
  }
}

TEST_P(DepthInSpace, IsZeroBelowAPlane) {
  const int n = GetParam();
  DepthSolver solver(options());
  Vector center = Vector::Zero(n);
  center[1] = 1.25;
  const ObjectDepth& outside = solver.solve(Ball(center, 1), euclidean(n));
  EXPECT_EQ(outside.status, DistanceStatus::optimal);
  EXPECT_EQ(outside.lower, 0);
  EXPECT_EQ(outside.upper, 0);
  const ObjectDepth& touching =
      solver.solve(PointSet(cube_vertices(n).colwise() + Vector(Vector::Unit(n, 0))), euclidean(n));
  EXPECT_EQ(touching.lower, 0);
  EXPECT_LT(touching.upper, 1e-13);
  Eigen::MatrixXd flat = cube_vertices(n);
  flat.row(2).setZero();
  const ObjectDepth& thin = solver.solve(PointSet(flat), euclidean(n));
  EXPECT_EQ(thin.lower, 0);
  EXPECT_LT(thin.upper, 1e-13);
}

TEST_P(DepthInSpace, ScalesWithTheSets) {
  const int n = GetParam();
  for (const double scale : {1e-100, 1e100}) {
    expect_depth(PointSet(scale * cross_polytope_vertices(n)), Ball(Vector::Zero(n), scale),
                 1 / std::sqrt(n));
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, DepthInSpace, ::testing::Values(4, 5, 6));

TEST(DepthSolver, AnswersInLowDimensionsAsForTwoObjects) {
  expect_depth(PointSet(cross_polytope_vertices(3)), euclidean(3), 1 / std::sqrt(3.0));
  expect_depth(PointSet(cross_polytope_vertices(2)), euclidean(2), 1 / std::sqrt(2.0));
  expect_depth(PointSet(Eigen::RowVector2d(-2, 3)), euclidean(1), 2);
}

TEST(DepthSolver, HasBoundsAloneBeyondSixDimensions) {
  DepthSolver solver;
  const ObjectDepth& depth = solver.solve(PointSet(cross_polytope_vertices(7)), euclidean(7));
  EXPECT_EQ(depth.status, DistanceStatus::precision_limit);
  EXPECT_EQ(depth.lower, 0);
  EXPECT_NEAR(depth.upper, 1, kRounding);
}

TEST(DepthSolver, OfTwoObjectsIsThatOfTheirDifference) {
  Random random(3);
  const PointSet A(sphere_points(4, 12, random)), B(0.5 * cube_vertices(4));
  ObjectDistanceSolver objects(options());
  DepthSolver solver(options());
  const ObjectDepth& pair = objects.solve(A, B, euclidean(4), ObjectEffects::depth).depth;
  Eigen::MatrixXd difference(4, 12 * 16);
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 16; ++j) difference.col(16 * i + j) = B.points().col(j) - A.points().col(i);
  const ObjectDepth& single = solver.solve(PointSet(difference), euclidean(4));
  EXPECT_EQ(pair.status, DistanceStatus::optimal);
  EXPECT_NEAR(pair.depth, single.depth, 1e-6 * single.depth);
  EXPECT_NEAR((pair.point_2 - pair.point_1 - pair.depth * pair.normal).norm(), 0, 1e-5);
}

TEST(DepthSolver, KeepsItsLimits) {
  // A ball about the origin has a sphere of least directions: no polytope of R^6 is as near to it as that.
  DistanceOptions limited = options(1e-4);
  limited.time_limit = 0.05;
  DepthSolver solver(limited);
  const ObjectDepth& depth = solver.solve(euclidean(6), euclidean(6));
  EXPECT_EQ(depth.status, DistanceStatus::time_limit);
  EXPECT_LE(depth.lower, 1);
  EXPECT_GT(depth.lower, 0.3);
  EXPECT_GE(depth.upper, 1);
}

TEST(DepthSolver, RefusesWhatItCannotUse) {
  DistanceOptions wrong;
  wrong.tolerance = 2;
  EXPECT_THROW(DepthSolver{wrong}, InvalidParameterError);
  EXPECT_THROW(DepthSolver().solve(euclidean(5), euclidean(6)), DimensionMismatchError);
}

}  // namespace
}  // namespace raygauge::test_depth_solver
