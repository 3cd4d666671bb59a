// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/sets/ellipsoid.h"
#include "tests/engine/both_methods.h"
#include "tests/engine/point_clouds.h"
#include "tests/linear_algebra.h"

namespace raygauge::test_solver_counters {
namespace {

class Counters : public BothMethods {
 protected:
  static DistanceResult random_solve(int n, Effects effects, StopRule rule = StopRule::certified_gap) {
    Random random(131);
    Eigen::MatrixXd a = sphere_points(n, 40 * n, random);
    a.row(0).array() += 3;
    DistanceOptions chosen = options(1e-6);
    chosen.stop_rule = rule;
    return DistanceSolver(chosen).solve(PointSet(a), PointSet(sphere_points(n, 40 * n, random)), effects);
  }
};
RAYGAUGE_BOTH_METHODS(Counters);

TEST_P(Counters, CountOuterAndInnerIterations) {
  for (const int n : {2, 3, 5, 10, 17}) {
    const DistanceCounters counters = random_solve(n, Effects::none).counters;
    EXPECT_GE(counters.outer_iterations, 1);
    EXPECT_GE(counters.ray_iterations, counters.outer_iterations);
    EXPECT_GT(counters.pivots, 0);
    EXPECT_GE(counters.support_queries, 2);
  }
}

TEST_P(Counters, CountNoWitnessThatWasNotAskedFor) {
  const DistanceResult plain = random_solve(5, Effects::none);
  EXPECT_EQ(plain.counters.witness_evaluations, 0);
  EXPECT_EQ(plain.contact_point.size(), 0);
  const DistanceResult asked = random_solve(5, Effects::witness);
  EXPECT_EQ(asked.counters.witness_evaluations, 1);
  EXPECT_EQ(asked.contact_point.size(), 5);
}

TEST_P(Counters, AreOtherwiseTheSameWithAndWithoutAWitness) {
  DistanceCounters asked = random_solve(5, Effects::witness).counters;
  asked.witness_evaluations = 0;
  EXPECT_EQ(asked, random_solve(5, Effects::none).counters);
}

class PublishedRule : public Counters {};
INSTANTIATE_TEST_SUITE_P(Methods, PublishedRule, ::testing::Values(DistanceMethod::zheng_yamane));

TEST_P(PublishedRule, StopsOnSigmaAndReportsTheTrueGap) {
  for (const int n : {2, 3, 5, 8}) {
    const DistanceResult certified = random_solve(n, Effects::none);
    const DistanceResult published = random_solve(n, Effects::none, StopRule::published_sigma);
    EXPECT_LT(std::fabs(published.sigma - 1), 1e-6);
    EXPECT_LE(published.lower, certified.upper);
    EXPECT_GE(published.upper, certified.lower);
    EXPECT_LE(published.counters.outer_iterations, certified.counters.outer_iterations);
    const bool closed = published.upper - published.lower <= 1e-6 * published.upper;
    EXPECT_EQ(published.status == DistanceStatus::optimal, closed) << to_string(published.status);
  }
}

/// Semi-axes 0.5, 1 and 2, in random directions.
Ellipsoid random_ellipsoid(const Vector& center, Random& random) {
  const Eigen::Vector3d semi_axes(0.5, 1, 2);
  return {center, orthogonal_factor(gaussian_points(3, 3, random)) * semi_axes.asDiagonal()};
}

// At a tolerance near what doubles resolve of rays, the same η used to come back 900 times.
TEST(ZhengYamaneCounters, ItHandsOverWhenRoundingKeepsItWhereItIs) {
  DistanceOptions options;
  options.method = DistanceMethod::zheng_yamane;
  options.tolerance = 1e-10;
  DistanceSolver solver(options);
  Random random(132);
  for (int i = 0; i < 50; ++i) {
    const Ellipsoid A = random_ellipsoid(8 * gaussian_points(3, 1, random).normalized(), random);
    const DistanceResult& result = solver.solve(A, random_ellipsoid(Vector::Zero(3), random));
    EXPECT_EQ(result.status, DistanceStatus::optimal) << "pair " << i;
    EXPECT_LE(result.counters.outer_iterations, 40) << "pair " << i;
  }
}

TEST(DirectCounters, HaveOneOuterIterationAndNoSigma) {
  const DistanceResult result = DistanceSolver().solve(PointSet(Vector::Ones(2)), PointSet(cube_vertices(2)));
  EXPECT_EQ(result.counters.outer_iterations, 1);
  EXPECT_TRUE(std::isnan(result.sigma));
}

}  // namespace
}  // namespace raygauge::test_solver_counters
