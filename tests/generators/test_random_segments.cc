// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/random_segments.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/polytopes.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_random_segments {
namespace {

TEST(RandomSegments, AreNearlyAUnitSphereWhereTheyAreMany) {
  const Instance instance = generate("random_segments", {1, 3, 4000, 0});
  const auto& Q = dynamic_cast<const Zonotope&>(*instance.Q);
  EXPECT_EQ(Q.generators().cols(), 4000);
  // E|u·g| of a uniform unit vector is 1/2 in R³: sqrt(3π/2) / 2.
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(Q.support_function(Vector::Unit(3, k)), 1.0854, 0.05);
}

// The corners of a zonotope in R² and R³ are few: as a set of points it is the same question.
Vector corner(const Zonotope& Z, const Vector& center, unsigned signs) {
  Vector point = center;
  for (Eigen::Index i = 0; i < Z.generators().cols(); ++i) {
    const double sign = ((signs >> i) & 1U) != 0 ? 1.0 : -1.0;
    for (Eigen::Index k = 0; k < point.size(); ++k) point[k] += sign * Z.generators()(k, i);
  }
  return point;
}

PointSet corners(const ConvexSet& set) {
  const auto& Z = dynamic_cast<const Zonotope&>(set);
  const Vector center = Z.center();
  Eigen::MatrixXd points(Z.dimension(), Eigen::Index{1} << Z.generators().cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    points.col(i) = corner(Z, center, static_cast<unsigned>(i));
  return PointSet(points);
}

TEST(RandomSegments, HaveTheDistanceOfTheirCorners) {
  for (const DistanceMethod method : {DistanceMethod::column_generation, DistanceMethod::zheng_yamane}) {
    DistanceOptions options;
    options.method = method;
    DistanceSolver solver(options);
    for (const int n : {2, 3, 5}) {
      const Instance instance = generate("random_segments", {2, n, 7, 0});
      const DistanceResult of_sets = solver.solve(*instance.A, *instance.Q);
      const DistanceResult& of_points = solver.solve(corners(*instance.A), corners(*instance.Q));
      EXPECT_EQ(of_sets.status, DistanceStatus::optimal) << n;
      EXPECT_NEAR(of_sets.distance, of_points.distance, 2e-6 * of_points.distance) << n;
      EXPECT_GT(of_sets.lower, 1) << n;
    }
  }
}

TEST(RandomSegments, StandInEitherRoleWithPointsInTheOther) {
  DistanceSolver solver;
  for (const std::string roles : {"zonotope_points", "points_zonotope"}) {
    const Instance instance = generate("random_segments", {3, 4, 80, 1}, {{"roles", roles}});
    const ConvexSet& of_segments = roles == "zonotope_points" ? *instance.A : *instance.Q;
    EXPECT_NE(dynamic_cast<const Zonotope*>(&of_segments), nullptr) << roles;
    const DistanceResult& result = solver.solve(*instance.A, *instance.Q);
    EXPECT_EQ(result.status, DistanceStatus::optimal) << roles;
    EXPECT_GT(result.lower, 1) << roles;
  }
}

TEST(RandomSegments, RefuseToBeFlat) {
  EXPECT_THROW(generate("random_segments", {1, 5, 4, 0}), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_random_segments
