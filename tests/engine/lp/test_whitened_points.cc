// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/whitened_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/numerics/decompositions.h"
#include "engine/numerics/floating_point.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_whitened_points {
namespace {

// The points of one side, back from their blocks, as columns.
Eigen::MatrixXd unpacked(const PricedPoints& points, int n) {
  constexpr std::ptrdiff_t kLanes = PointSet::kLanes;
  Eigen::MatrixXd all(n, points.block_count * kLanes);
  for (std::ptrdiff_t i = 0; i < all.cols(); ++i) {
    for (int k = 0; k < n; ++k) all(k, i) = points.blocks[i / kLanes * n * kLanes + k * kLanes + i % kLanes];
  }
  return all;
}

ColumnPool pool_of(const Eigen::MatrixXd& points) {
  ColumnPool pool;
  pool.clear(static_cast<int>(points.rows()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) pool.add(points.col(i).eval().data());
  pool.fill_up();
  return pool;
}

Stopwatch unlimited() {
  Stopwatch stopwatch;
  stopwatch.start(kInfinity);
  return stopwatch;
}

TEST(WhitenedPoints, OfAShearAreRoundAndHaveTheSameProducts) {
  Random random(7);
  const int n = 12;
  Eigen::MatrixXd shear = integer_points(n, n, 2, random).triangularView<Eigen::UnitUpper>();
  shear = shear * Eigen::MatrixXd(integer_points(n, n, 2, random).triangularView<Eigen::UnitLower>());
  const Eigen::MatrixXd a = shear * sphere_points(n, 21, random), q = shear * sphere_points(n, 30, random);
  WhitenedPoints points;
  ASSERT_TRUE(points.compute(pool_of(a), pool_of(q), n, unlimited()));
  const Eigen::MatrixXd A = unpacked(points.A(), n), Q = unpacked(points.Q(), n);
  EXPECT_EQ(points.A().size, 21);
  EXPECT_EQ(points.Q().size, 30);
  EXPECT_EQ(A.cols(), 24);
  for (Eigen::Index i = 21; i < 24; ++i) EXPECT_EQ(A.col(i), A.col(20));
  const Eigen::MatrixXd both =
      A.leftCols(21) * A.leftCols(21).transpose() + Q.leftCols(30) * Q.leftCols(30).transpose();
  EXPECT_GT(least_eigenvalue(both / 51), 0.1);
  EXPECT_GT(least_eigenvalue(10 * Eigen::MatrixXd::Identity(n, n) - both / 51), 0);
  const Vector u = sphere_points(n, 1, random);
  Vector turned = u;
  points.turn(turned.data());
  EXPECT_TRUE((a.transpose() * u).isApprox(A.leftCols(21).transpose() * turned, 1e-12));
  points.turn_back(turned.data());
  points.turn(turned.data());
  EXPECT_TRUE((q.transpose() * u).isApprox(Q.leftCols(30).transpose() * turned, 1e-12));
}

// Every second point is in a plane, and all points that R is of.
TEST(WhitenedPoints, SpanWhereAChoiceOfThemDoesNot) {
  Random random(9);
  Eigen::MatrixXd a = sphere_points(8, 24, random);
  for (Eigen::Index i = 0; i < 24; i += 2) a(3, i) = 0;
  WhitenedPoints points;
  ASSERT_TRUE(points.compute(pool_of(a.leftCols(12)), pool_of(a.rightCols(12)), 8, unlimited()));
  const Eigen::MatrixXd A = unpacked(points.A(), 8).leftCols(12), Q = unpacked(points.Q(), 8).leftCols(12);
  EXPECT_TRUE((A * A.transpose() + Q * Q.transpose()).isApprox(24 * Eigen::MatrixXd::Identity(8, 8), 1e-12));
}

TEST(WhitenedPoints, AreNotFoundWithoutTime) {
  Random random(10);
  const Eigen::MatrixXd a = sphere_points(5, 20, random);
  Stopwatch stopwatch;
  stopwatch.start(0);
  WhitenedPoints points;
  EXPECT_FALSE(points.compute(pool_of(a), pool_of(a), 5, stopwatch));
}

TEST(WhitenedPoints, AreNoneOfPointsInAPlane) {
  Random random(8);
  Eigen::MatrixXd flat = sphere_points(4, 20, random);
  flat.row(2).setZero();
  WhitenedPoints points;
  EXPECT_FALSE(points.compute(pool_of(flat), pool_of(flat), 4, unlimited()));
  EXPECT_FALSE(points.compute(pool_of(flat.leftCols(1)), pool_of(flat.leftCols(2)), 4, unlimited()));
}

}  // namespace
}  // namespace raygauge::test_whitened_points
