// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/axis_points.h"

#include <gtest/gtest.h>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_axis_points {
namespace {

PricedPoints view(const PointSet& S) {
  PricedPoints points;
  points.blocks = S.data();
  points.block_count = S.block_count();
  points.size = S.size();
  return points;
}

TEST(AxisPoints, AreTheFarthestOnEveryHalfAxis) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(3, 11);
  points(0, 1) = 2;
  points(0, 2) = -1;
  points(1, 3) = 0.5;
  points(1, 9) = 4;  // in the second block
  points(2, 10) = -3;
  points.col(5) << 9, 9, 0;
  points.col(6) << 0, 9, 9;
  const PointSet S(points);
  AxisPoints axes;
  axes.find(view(S), 3);
  EXPECT_TRUE(axes.any());
  EXPECT_FALSE(axes.complete());
  EXPECT_EQ(axes.index(0, true), 1);
  EXPECT_EQ(axes.index(0, false), 2);
  EXPECT_EQ(axes.index(1, true), 9);
  EXPECT_EQ(axes.length(1, true), 4);
  EXPECT_LT(axes.index(1, false), 0);
  EXPECT_LT(axes.index(2, true), 0);
  EXPECT_EQ(axes.index(2, false), 10);
}

TEST(AxisPoints, OfACrossPolytopeAreComplete) {
  for (const int n : {1, 4, 5, 20}) {
    AxisPoints axes;
    axes.find(view(PointSet(cross_polytope_vertices(n))), n);
    EXPECT_TRUE(axes.complete()) << "n = " << n;
  }
}

// d is a 1-norm: of points, of cross-polytopes, of the origin in A; with half of the axes missing, which
// makes Q a simplex, and with other points between.
TEST(AxisPoints, MakeFirstBasesOfTheSameDistances) {
  Random random(71);
  for (const int n : {16, 40, 100}) {
    const Eigen::MatrixXd cross = cross_polytope_vertices(n);
    DistanceSolver solver;
    const Vector c = gaussian_points(n, 1, random);
    const DistanceResult& of_point = solver.solve(PointSet(c), PointSet(cross));
    EXPECT_NEAR(of_point.distance, c.lpNorm<1>(), 1e-12 * c.lpNorm<1>()) << "n = " << n;
    EXPECT_EQ(of_point.status, DistanceStatus::optimal);
    EXPECT_EQ(of_point.counters.pivots, 0) << "the first basis is optimal";

    const Eigen::MatrixXd moved = cross.colwise() + 3 * Eigen::VectorXd::Ones(n);
    EXPECT_NEAR(solver.solve(PointSet(moved), PointSet(cross)).distance, 3 * n - 1, 1e-9) << "n = " << n;
    EXPECT_EQ(solver.solve(PointSet(cross), PointSet(cross)).status, DistanceStatus::contains_origin);

    // Simplex {e_k, -1}: gauge Σp + (n + 1) max(0, -min p).
    const double expected = c.sum() + (n + 1) * std::max(0.0, -c.minCoeff());
    const DistanceResult& of_simplex = solver.solve(PointSet(c), PointSet(simplex_vertices(n)));
    EXPECT_NEAR(of_simplex.distance, expected, 1e-9 * expected) << "n = " << n;
    EXPECT_EQ(of_simplex.status, DistanceStatus::optimal);

    Eigen::MatrixXd mixed(n, 3 * n);
    mixed << sphere_points(n, n, random) * 1.5, 2.0 * cross;
    const DistanceResult with_others = solver.solve(PointSet(moved), PointSet(mixed));
    EXPECT_EQ(with_others.status, DistanceStatus::optimal) << "n = " << n;
    Eigen::MatrixXd turned = mixed;  // no point on an axis, the same distance
    turned.row(0) += turned.row(1);
    Eigen::MatrixXd moved_too = moved;
    moved_too.row(0) += moved_too.row(1);
    const DistanceResult& without = solver.solve(PointSet(moved_too), PointSet(turned));
    EXPECT_NEAR(without.distance, with_others.distance, 1e-5 * without.distance) << "n = " << n;
  }
}

}  // namespace
}  // namespace raygauge::test_axis_points
