// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/gauge_bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/queries/solver.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_gauge_bound {
namespace {

double gauge_bound(const Eigen::MatrixXd& points) {
  ColumnPool Q;
  Q.clear(static_cast<int>(points.rows()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) Q.add(points.col(i).data());
  Stopwatch unlimited;
  GaugeBound bound;
  return bound.compute(Q, static_cast<int>(points.rows()), best_kernels(), unlimited);
}

TEST(GaugeBound, IsAboveTheGaugeOfEveryVector) {
  Random random(151);
  for (const int n : {1, 2, 3, 5, 10, 20}) {
    const Eigen::MatrixXd points = sphere_points(n, 20 * n, random);
    const double bound = gauge_bound(points);
    ASSERT_TRUE(std::isfinite(bound)) << "n = " << n;
    const PointSet Q(points);
    for (int trial = 0; trial < 20; ++trial) {
      Vector r = gaussian_points(n, 1, random);
      r /= r.lpNorm<Eigen::Infinity>();
      EXPECT_LE(DistanceSolver().solve(PointSet(r), Q).lower, bound);
    }
  }
}

TEST(GaugeBound, IsNotWildlyAboveIt) {
  // Of the cube the best G is 1, of the cross-polytope n; cones of facets cost some factors of n on the way.
  for (const int n : {1, 2, 3, 5, 8}) {
    EXPECT_GE(gauge_bound(cube_vertices(n)), 1);
    EXPECT_LE(gauge_bound(cube_vertices(n)), 1000 * n);
    EXPECT_GE(gauge_bound(cross_polytope_vertices(n)), n);
    EXPECT_LE(gauge_bound(cross_polytope_vertices(n)), 100 * n);
  }
}

TEST(GaugeBound, IsInfiniteWhereThePointsDoNotSurroundTheOrigin) {
  EXPECT_TRUE(std::isinf(gauge_bound(cube_vertices(3).array() + 2)));  // all on one side
  EXPECT_TRUE(std::isinf(gauge_bound(cube_vertices(3).array() + 1)));  // the origin at a vertex
  Eigen::MatrixXd flat = cross_polytope_vertices(3);
  flat.row(1).setZero();
  EXPECT_TRUE(std::isinf(gauge_bound(flat)));
  EXPECT_TRUE(std::isinf(gauge_bound(Vector::Ones(3))));
}

}  // namespace
}  // namespace raygauge::test_gauge_bound
