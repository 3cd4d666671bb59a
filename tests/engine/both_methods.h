// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Expects the same answer to the last bit, by the same work.
inline void expect_same_bits(const DistanceResult& one, const DistanceResult& other) {
  EXPECT_EQ(one.status, other.status);
  EXPECT_EQ(one.distance, other.distance);
  EXPECT_EQ(one.lower, other.lower);
  EXPECT_EQ(one.upper, other.upper);
  EXPECT_EQ(one.normal, other.normal);
  EXPECT_EQ(one.contact_point, other.contact_point);
  EXPECT_EQ(one.counters, other.counters);
}

/// Fixture of what must hold for `column_generation` and for `zheng_yamane` alike.
class BothMethods : public ::testing::TestWithParam<DistanceMethod> {
 protected:
  static DistanceOptions options(double tolerance) {
    DistanceOptions result;
    result.method = GetParam();
    result.tolerance = tolerance;
    return result;
  }

  static DistanceResult solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q, double tolerance = 1e-6,
                              Effects effects = Effects::none) {
    return DistanceSolver(options(tolerance)).solve(PointSet(A), PointSet(Q), effects);
  }

  /// Solves to `tolerance`; the answer must be certified and its bounds must hold `truth`.
  static void expect_distance(double truth, const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q,
                              double tolerance = 1e-12) {
    const DistanceResult result = solve(A, Q, tolerance);
    EXPECT_EQ(result.status, DistanceStatus::optimal) << to_string(result.status) << ", truth " << truth;
    EXPECT_LE(result.lower, truth);
    EXPECT_GE(result.upper, truth);
    EXPECT_LE(result.lower, result.distance);
    EXPECT_LE(result.distance, result.upper);
    EXPECT_LE(result.upper - result.lower, tolerance * result.upper);
  }
};

/// Instantiates a test suite derived from BothMethods, or BothMethods itself.
#define RAYGAUGE_BOTH_METHODS(suite)                                                                      \
  INSTANTIATE_TEST_SUITE_P(                                                                               \
      Methods, suite, ::testing::Values(DistanceMethod::column_generation, DistanceMethod::zheng_yamane), \
      [](const auto& instance) { return std::string(to_string(instance.param)); })

/// The same for `newton`, where sets are concerned that have second-order information.
#define RAYGAUGE_NEWTON_TOO(suite)                                                   \
  INSTANTIATE_TEST_SUITE_P(Newton, suite, ::testing::Values(DistanceMethod::newton), \
                           [](const auto& instance) { return std::string(to_string(instance.param)); })

}  // namespace raygauge
