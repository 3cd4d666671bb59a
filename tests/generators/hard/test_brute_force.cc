// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/generators/hard/brute_force.h"

#include <gtest/gtest.h>

namespace raygauge::test_brute_force {
namespace {

TEST(BruteForce, FindsTheGaugeOfAPointInATriangle) {
  Eigen::MatrixXd Q(2, 3), A(2, 1);
  Q << 1, -1, 0, 0, 0, 1;
  A << 0.25, 0.5;
  EXPECT_EQ(brute_force_distance(A, Q), Rational(3, 4));
}

TEST(BruteForce, FindsNothingWhereQCannotReach) {
  Eigen::MatrixXd Q(2, 2), A(2, 2);
  Q << 1, -1, 0, 0;
  A << 0, 1, 1, 1;
  EXPECT_FALSE(brute_force_distance(A, Q).has_value());
}

TEST(BruteForce, FindsZeroWhereTheOriginIsInA) {
  Eigen::MatrixXd Q(1, 1), A(1, 2);
  Q << 1;
  A << -3, 1;
  EXPECT_EQ(brute_force_distance(A, Q), Rational(0));
}

TEST(BruteForce, KnowsTheNearestDouble) {
  EXPECT_TRUE(is_nearest_double(Rational(1, 3), 1.0 / 3));
  EXPECT_FALSE(is_nearest_double(Rational(1, 3), 0x1.5555555555556p-2));
  EXPECT_FALSE(is_nearest_double(Rational(1), 1 - 0x1p-53));
}

}  // namespace
}  // namespace raygauge::test_brute_force
