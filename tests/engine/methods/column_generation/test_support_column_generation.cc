// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_support_column_generation {
namespace {

// Points of the half-space x_0 >= 0.1.
PointSet points_in_front(int n, Random& random) {
  Eigen::MatrixXd points = sphere_points(n, 2 * n + 3, random);
  points.row(0) = points.row(0).cwiseAbs().array() + 0.1;
  return PointSet(points);
}

// In x_0 <= -0.5.
Vector center_behind(int n, Random& random) {
  Vector center = sphere_points(n, 1, random);
  center[0] = -3;
  return center;
}

Zonotope zonotope_behind(int n, Random& random) {
  Eigen::MatrixXd generators = sphere_points(n, n + 2, random);
  generators.row(0) *= 2.5 / generators.row(0).cwiseAbs().sum();
  return {center_behind(n, random), generators};
}

// A cube of half width 1, cut by four planes at the same distance.
HPolytope polytope_behind(int n, Random& random) {
  const auto rows = static_cast<Eigen::Index>(2) * n;
  Eigen::MatrixXd F(rows + 4, n);
  F << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n),
      sphere_points(n, 4, random).transpose();
  return {F, Vector::Ones(rows + 4) + F * center_behind(n, random)};
}

// A vertex of the first phase leaves n points of Q in its plane, up to rounding: bounds of [4e16, inf] and
// `precision_limit` were once the end of most of these.
void expect_unreachable(const ConvexSet& A, const ConvexSet& Q, int n) {
  DistanceOptions options;
  options.method = DistanceMethod::column_generation;
  DistanceSolver solver(options);
  const DistanceResult& result = solver.solve(A, Q);
  EXPECT_EQ(result.status, DistanceStatus::unreachable) << "n = " << n;
  EXPECT_EQ(result.lower, INFINITY) << "n = " << n;
  EXPECT_LT(A.support_function(result.normal), 0) << "n = " << n << ": a Farkas direction";
  constexpr double kRounding = 1e-15;  // of this evaluation
  EXPECT_LT(Q.support_function(-result.normal), kRounding * result.normal.norm()) << "n = " << n;
}

TEST(SupportColumnGeneration, ProvesThatSetsCannotBeReached) {
  for (const int n : {2, 3, 5, 8, 15, 30}) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      Random random(700 + seed);
      const PointSet Q = points_in_front(n, random);
      const Zonotope zonotope = zonotope_behind(n, random);
      const HPolytope polytope = polytope_behind(n, random);
      expect_unreachable(zonotope, Q, n);
      expect_unreachable(polytope, Q, n);
      expect_unreachable(Q, zonotope, n);
      expect_unreachable(Q, polytope, n);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_support_column_generation
