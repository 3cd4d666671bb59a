// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/zero_weights.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/engine/point_clouds.h"

namespace raygauge::test_zero_weights {
namespace {

// Integers with B x = e_m for an x that is zero but in its last `support` components: the last columns, times
// the coefficients given, make e_m.
Eigen::MatrixXd matrix_with_support(int m, int support, Random& random) {
  Eigen::MatrixXd B = integer_points(m, m, 1000, random);
  B.col(m - 1) = Eigen::VectorXd::Unit(m, m - 1);
  for (int i = 1; i < support; ++i) B.col(m - 1) -= 3 * B.col(m - 1 - i);
  return B;
}

std::vector<int> first_positions(int count) {
  std::vector<int> positions;
  for (int i = 0; i < count; ++i) positions.push_back(i);
  return positions;
}

bool are_zero(const Eigen::MatrixXd& B, const std::vector<int>& positions) {
  return weights_are_zero(B.data(), B.rows(), static_cast<int>(B.cols()), positions, Stopwatch());
}

TEST(ZeroWeights, ProvesComponentsThatAreZero) {
  Random random(41);
  for (const int m : {1, 2, 3, 11, 51}) {
    for (const int support : {1, 2, m / 2 + 1}) {
      if (support > m) continue;
      const Eigen::MatrixXd B = matrix_with_support(m, support, random);
      EXPECT_TRUE(are_zero(B, first_positions(m - support))) << "m = " << m << ", support = " << support;
    }
  }
}

TEST(ZeroWeights, FindsEveryComponentThatIsNot) {
  Random random(42);
  for (const int m : {2, 11, 51}) {
    const int support = m / 2 + 1;
    const Eigen::MatrixXd B = matrix_with_support(m, support, random);
    for (int i = m - support; i < m; ++i) {
      EXPECT_FALSE(are_zero(B, {i})) << "m = " << m << ", i = " << i;
    }
  }
}

// x_0 = ∓ 2^-40 to 2^-960 or so: no enclosure in a few doubles tells it from zero.
TEST(ZeroWeights, TellsTinyComponentsFromZero) {
  for (const int m : {2, 9, 25}) {
    Eigen::MatrixXd B = Eigen::MatrixXd::Identity(m, m) * 0x1p20;
    for (int k = 0; k + 1 < m; ++k) B(k, k + 1) = 0x1p-20;
    B(m - 1, m - 1) = 1;
    EXPECT_FALSE(are_zero(B, {0})) << "m = " << m;
    B(0, 1) = 0;
    EXPECT_TRUE(are_zero(B, {0})) << "m = " << m;
  }
}

TEST(ZeroWeights, DoesNotDependOnPowersOfTwoOfRows) {
  Random random(43);
  Eigen::MatrixXd B = matrix_with_support(11, 4, random);
  for (int k = 0; k < 11; ++k) B.row(k) *= std::ldexp(1.0, 90 * k - 450);
  EXPECT_TRUE(are_zero(B, first_positions(7)));
  EXPECT_FALSE(are_zero(B, first_positions(8)));
}

TEST(ZeroWeights, DecidesNothingWhereIntegersAreLongOrTheMatrixIsSingular) {
  Eigen::Matrix2d B;
  B << 1, 0x1p-70, 0, 1;
  EXPECT_FALSE(are_zero(B, {0})) << "71 bits";
  B << 0, 0, 1, 1;
  EXPECT_FALSE(are_zero(B, {0})) << "singular";
  B << 2147483647.0, 0, 0, 1;
  EXPECT_FALSE(are_zero(B, {0})) << "singular modulo the prime, and x_0 = 0 all the same";
}

TEST(ZeroWeights, EndsWithTheStopwatch) {
  Random random(44);
  const Eigen::MatrixXd B = matrix_with_support(11, 4, random);
  Stopwatch late;
  late.start(0);
  EXPECT_FALSE(weights_are_zero(B.data(), 11, 11, std::array{0}, late));
}

}  // namespace
}  // namespace raygauge::test_zero_weights
