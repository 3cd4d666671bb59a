// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/membership.h"

#include <gtest/gtest.h>

#include "engine/numerics/stopwatch.h"
#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_origin_in_interior {
namespace {

using Answer = OriginInInterior::Answer;

void expect_on_one_side(const Eigen::MatrixXd& Q) {
  const OriginInInterior found = origin_in_interior(PointSet(Q));
  ASSERT_EQ(found.answer, Answer::violated);
  ASSERT_EQ(found.direction.size(), Q.rows());
  EXPECT_FALSE(found.direction.isZero(0));
  for (Eigen::Index j = 0; j < Q.cols(); ++j) EXPECT_GE(exact_dot(found.direction, Q.col(j)), 0);
}

TEST(OriginInInterior, HoldsForBodiesAroundTheOrigin) {
  for (const int n : {1, 2, 3, 6}) {
    EXPECT_EQ(origin_in_interior(PointSet(cube_vertices(n))).answer, Answer::holds);
    EXPECT_EQ(origin_in_interior(PointSet(cross_polytope_vertices(n))).answer, Answer::holds);
  }
}

TEST(OriginInInterior, HoldsHoweverNearAFacetIs) {
  Eigen::MatrixXd Q(2, 3);
  for (const double delta : {1e-9, 1e-300}) {
    Q << -delta, -delta, 1, 1, -1, 0;
    EXPECT_EQ(origin_in_interior(PointSet(Q)).answer, Answer::holds);
  }
}

TEST(OriginInInterior, IsViolatedByAFacetThroughTheOrigin) {
  Eigen::MatrixXd Q(2, 3);
  Q << 0, 0, 2, 1, -1, 0;
  expect_on_one_side(Q);
}

TEST(OriginInInterior, IsViolatedByABodyBesideTheOrigin) {
  Eigen::MatrixXd Q(2, 3);
  Q << 1, 1, 2, 1, -1, 0;
  expect_on_one_side(Q);
}

TEST(OriginInInterior, IsViolatedByAFlatBody) {
  Eigen::MatrixXd Q = Eigen::MatrixXd::Zero(3, 4);
  Q.topRows(2) = cross_polytope_vertices(2);
  expect_on_one_side(Q);
  Q.row(2) = Q.row(0) + Q.row(1);  // flat, but along no axis
  expect_on_one_side(Q);
}

TEST(OriginInInterior, IsUnknownWithoutTime) {
  EXPECT_EQ(origin_in_interior(PointSet(cube_vertices(3)), 0).answer, Answer::unknown);
}

// Once n + 1 linear programs, some of which went on in exact arithmetic: 11 s here.
TEST(OriginInInterior, IsDecidedInManyDimensions) {
  Random random(1800);
  const PointSet around(sphere_points(100, 600, random));
  EXPECT_EQ(origin_in_interior(around, 5.0).answer, Answer::holds);
  const PointSet few(sphere_points(100, 110, random));
  const OriginInInterior found = origin_in_interior(few, 5.0);
  EXPECT_EQ(found.answer, Answer::violated);
  EXPECT_EQ(found.direction.size(), 100);
}

TEST(OriginInInterior, EndsWithinTheTimeLimit) {
  Random random(1801);
  const PointSet Q(sphere_points(200, 2000, random));
  for (const double limit : {0.0, 0.01, 0.1}) {
    Stopwatch stopwatch;
    stopwatch.start(100);
    origin_in_interior(Q, limit);
    EXPECT_LE(stopwatch.seconds(), 1.2 * limit + 0.1);
  }
}

}  // namespace
}  // namespace raygauge::test_origin_in_interior
