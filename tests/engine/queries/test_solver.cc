// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::test_solver {
namespace {

Eigen::MatrixXd sphere_points(int n, int N, std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd points(n, N);
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < n; ++k) points(k, i) = normal(engine);
    points.col(i).normalize();
  }
  return points;
}

Eigen::MatrixXd cube_vertices(int n) {
  Eigen::MatrixXd vertices(n, 1 << n);
  for (int i = 0; i < (1 << n); ++i) {
    for (int k = 0; k < n; ++k) vertices(k, i) = (i >> k) % 2 == 0 ? -1.0 : 1.0;
  }
  return vertices;
}

Eigen::MatrixXd cross_polytope_vertices(int n) {
  Eigen::MatrixXd vertices(n, 2 * n);
  vertices << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  return vertices;
}

class BothMethods : public ::testing::TestWithParam<DistanceMethod> {
 protected:
  DistanceOptions options(double tolerance = 1e-6) const {
    DistanceOptions result;
    result.method = GetParam();
    result.tolerance = tolerance;
    return result;
  }
};

TEST_P(BothMethods, GiveTheMaximumNormOfAPointAgainstTheCube) {
  Vector p(4);
  p << 0.5, -3.25, 2.0, 1.0;
  DistanceSolver solver(options(1e-12));
  const DistanceResult& result = solver.solve(PointSet(p), PointSet(cube_vertices(4)));
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.lower, 3.25);
  EXPECT_GE(result.upper, 3.25);
}

TEST_P(BothMethods, GiveTheSumNormOfAPointAgainstTheCrossPolytope) {
  Vector p(3);
  p << 0.5, -3.25, 2.0;
  DistanceSolver solver(options(1e-12));
  const DistanceResult& result = solver.solve(PointSet(p), PointSet(cross_polytope_vertices(3)));
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_LE(result.lower, 5.75);
  EXPECT_GE(result.upper, 5.75);
}

TEST_P(BothMethods, CertifyRandomSpherePairsToTheTolerance) {
  std::mt19937_64 engine(7);
  for (const int n : {2, 3, 5, 8, 10, 17}) {
    const PointSet Q(sphere_points(n, 60 * n, engine));
    Eigen::MatrixXd a = sphere_points(n, 60 * n, engine);
    a.row(0).array() += 3;
    const PointSet A(a);
    DistanceSolver solver(options());
    const DistanceResult& result = solver.solve(A, Q, Effects::witness);
    ASSERT_EQ(result.status, DistanceStatus::optimal) << "n = " << n;
    EXPECT_LE(result.upper - result.lower, 1e-6 * result.upper);
    // The witness lies on the supporting hyperplanes of A and of dQ.
    EXPECT_NEAR(result.normal.dot(result.contact_point), -result.distance, 1e-6 * result.distance);
  }
}

TEST_P(BothMethods, SayThatTheOriginLiesInA) {
  DistanceSolver solver(options());
  const DistanceResult& result =
      solver.solve(PointSet(cube_vertices(3)), PointSet(cross_polytope_vertices(3)));
  EXPECT_EQ(result.status, DistanceStatus::contains_origin);
  EXPECT_EQ(result.distance, 0.0);
}

TEST_P(BothMethods, SayThatNoMultipleOfQReachesA) {
  Eigen::MatrixXd q(2, 3);
  q << 0, 0, 2, 1, -1, 0;
  Vector p(2);
  p << -1e-9, 0.5;
  DistanceSolver solver(options());
  const DistanceResult& result = solver.solve(PointSet(p), PointSet(q));
  EXPECT_EQ(result.status, DistanceStatus::unreachable);
  EXPECT_TRUE(std::isinf(result.distance));
}

TEST_P(BothMethods, ReachAPointWhenTheOriginIsOnTheBoundaryOfQ) {
  Eigen::MatrixXd q(2, 3);
  q << 0, 0, 2, 1, -1, 0;
  Vector p(2);
  p << 3, 1;
  DistanceSolver solver(options());
  const DistanceResult& result = solver.solve(PointSet(p), PointSet(q));
  EXPECT_EQ(result.status, DistanceStatus::optimal);
  EXPECT_NEAR(result.distance, 2.5, 1e-6);
}

TEST_P(BothMethods, RefuseSetsOfDifferentDimension) {
  DistanceSolver solver(options());
  EXPECT_THROW(solver.solve(PointSet(cube_vertices(2)), PointSet(cube_vertices(3))), DimensionMismatchError);
}

INSTANTIATE_TEST_SUITE_P(Methods, BothMethods,
                         ::testing::Values(DistanceMethod::column_generation, DistanceMethod::zheng_yamane),
                         [](const auto& instance) { return std::string(to_string(instance.param)); });

// Magnitudes that span 600 decades: scaling to magnitude 1 would lose the small coordinates, and once did.
TEST(DistanceSolver, ClaimsNothingThatScalingLost) {
  Eigen::MatrixXd a(2, 2);
  a << 1e200, 1e-200, -1e-300, 1e200;
  Eigen::MatrixXd q(2, 1);
  q << -1e-300, 1e200;
  DistanceSolver solver;
  const DistanceResult plane = solver.solve(PointSet(a), PointSet(q));
  EXPECT_NE(plane.status, DistanceStatus::contains_origin);
  EXPECT_TRUE(std::isinf(plane.upper));

  Eigen::MatrixXd line_a(1, 2);
  line_a << 1e300, 1e-300;
  const DistanceResult line = solver.solve(PointSet(line_a), PointSet(Eigen::MatrixXd::Constant(1, 1, -1.0)));
  EXPECT_NE(line.status, DistanceStatus::contains_origin);
  EXPECT_TRUE(std::isinf(line.upper));
}

TEST(DistanceSolver, RefusesOptionsOutsideTheirRange) {
  DistanceOptions options;
  options.tolerance = 0;
  EXPECT_THROW(DistanceSolver{options}, InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_solver
