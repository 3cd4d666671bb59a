// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/polytopes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/point_clouds.h"

namespace raygauge {
namespace {

TEST(Zonotope, OfUnitVectorsIsABox) {
  Random random(2);
  for (const int n : {1, 2, 3, 7, 40}) {
    const Vector c = gaussian_points(n, 1, random);
    const Zonotope zonotope(c, Eigen::MatrixXd::Identity(n, n));
    const Box box(c - Vector::Ones(n), c + Vector::Ones(n));
    for (int trial = 0; trial < 20; ++trial) {
      const Vector u = gaussian_points(n, 1, random);
      EXPECT_NEAR(zonotope.support_function(u), box.support_function(u), 1e-13 * u.lpNorm<1>()) << n;
      EXPECT_LT((zonotope.support_mapping(u) - box.support_mapping(u)).norm(), 1e-13 * n) << n;
    }
    EXPECT_NEAR(zonotope.inner_radius_unchecked(c.data()), 1, 1e-12 * n) << n;
    EXPECT_LE(zonotope.inner_radius_unchecked(c.data()), 1) << n;
  }
}

TEST(Zonotope, IsTheHullOfItsSignedSums) {
  Random random(6);
  const int n = 4, m = 7;
  const Eigen::MatrixXd G = gaussian_points(n, m, random);
  const Vector c = 8 * Vector::Unit(n, 1);
  Eigen::MatrixXd sums(n, 1 << m);
  for (int i = 0; i < 1 << m; ++i) {
    Vector signs(m);
    for (int k = 0; k < m; ++k) signs[k] = (i >> k & 1) == 1 ? 1 : -1;
    sums.col(i) = G * signs;
  }
  const PointSet hull_at_origin(sums), hull((sums.colwise() + c).eval());
  const Zonotope zonotope(c, G), at_origin(Vector::Zero(n), G);
  const PointSet other(
      (Eigen::MatrixXd(n, 2 * n) << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n))
          .finished());
  DistanceSolver solver;
  const double as_A = solver.solve(hull, other).distance;
  if (as_A > 0) {
    EXPECT_NEAR(solver.solve(zonotope, other).distance, as_A, 2e-6 * as_A);
  }
  const PointSet point((20 * Vector::Ones(n)).eval());
  const double as_Q = solver.solve(point, hull_at_origin).distance;
  const DistanceResult result = solver.solve(point, at_origin);
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_NEAR(result.distance, as_Q, 2e-6 * as_Q);
}

TEST(Zonotope, HasBallsInsideOnlyWhereItIsNotFlat) {
  const Vector c = Vector::Zero(3);
  Eigen::MatrixXd flat(3, 2);
  flat << 1, 0, 0, 1, 0, 0;
  EXPECT_EQ(Zonotope(c, flat).inner_radius_unchecked(c.data()), 0);
  EXPECT_EQ(Zonotope(c, Eigen::MatrixXd(3, 0)).support_function(Vector::Ones(3)), 0);
  EXPECT_DOUBLE_EQ(Zonotope(c, flat).support_function(Vector{{1, -2, 5}}), 3);
}

TEST(Zonotope, ContainsWhatItsGeneratorsReach) {
  Eigen::MatrixXd G(2, 3);
  G << 1, 0, 1, 0, 1, 1;
  const Zonotope hexagon(Vector::Zero(2), G);
  EXPECT_EQ(contains(hexagon, Vector{{1.9, 1.9}}), Membership::inside);
  EXPECT_EQ(contains(hexagon, Vector{{1.5, -0.9}}), Membership::outside);
}

TEST(Zonotope, RefusesWhatDoesNotFit) {
  EXPECT_THROW(Zonotope(Vector::Zero(3), Eigen::MatrixXd::Identity(2, 2)), DimensionMismatchError);
  EXPECT_THROW(Zonotope(Vector::Constant(1, std::nan("")), Eigen::MatrixXd::Identity(1, 1)), NonFiniteError);
  EXPECT_THROW(Zonotope(Vector::Zero(1), Eigen::MatrixXd::Constant(1, 1, std::nan(""))), NonFiniteError);
}

}  // namespace
}  // namespace raygauge
