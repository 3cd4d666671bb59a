// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/rank_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "raygauge/exceptions.h"

namespace raygauge::test_rank_tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(SignedRank, CountsSignsExactly) {
  EXPECT_DOUBLE_EQ(signed_rank_p({1, 2, 3, 4, 5}), 2.0 / 32);     // only all or no sign so extreme
  EXPECT_DOUBLE_EQ(signed_rank_p({-1, 2, 3, 4, 5}), 4.0 / 32);    // rank sums 0 and 1
  EXPECT_DOUBLE_EQ(signed_rank_p({-1, -2, 3, 4, 5}), 10.0 / 32);  // 0, 1, 2, 3 = {3} and {1, 2}
}

TEST(SignedRank, SharesRanksOfTies) {
  // Ranks 1.5, 1.5, 3: sums of at most 1.5 come from {}, {1.5}, {1.5}.
  EXPECT_DOUBLE_EQ(signed_rank_p({-1, 1, 2}), 6.0 / 8);
}

TEST(SignedRank, LeavesOutZerosAndTakesInfinities) {
  EXPECT_DOUBLE_EQ(signed_rank_p({0, 0}), 1);
  EXPECT_DOUBLE_EQ(signed_rank_p({0, 1, 2, 3, 4, kInfinity}), 2.0 / 32);
  EXPECT_THROW(signed_rank_p({std::nan("")}), NonFiniteError);
}

TEST(SignedRank, IsApproximatedByANormalDistributionForManyDifferences) {
  // All of 1 … 100 positive: mean 2525, variance 100 * 101 * 201 / 24.
  std::vector<double> differences;
  for (int i = 1; i <= 100; ++i) differences.push_back(i);
  EXPECT_NEAR(signed_rank_p(differences) / std::erfc(2524.5 / std::sqrt(2 * 100 * 101 * 201 / 24.0)), 1,
              1e-9);
}

TEST(RankSum, FollowsTheNormalApproximation) {
  // U = 0 of 5 and 5: mean 12.5, variance 25 * 11 / 12, z = 12 / sqrt(22.9167) = 2.50672.
  EXPECT_NEAR(rank_sum_p({1, 2, 3, 4, 5}, {6, 7, 8, 9, 10}), std::erfc(12 / std::sqrt(2 * 25 * 11.0 / 12)),
              1e-12);
  EXPECT_DOUBLE_EQ(rank_sum_p({1, 1}, {1, 1, 1}), 1);
  EXPECT_THROW(rank_sum_p({}, {1}), EmptySetError);
}

TEST(RankTests, CallEqualDistributionsDifferentInAboutFivePercent) {
  std::mt19937_64 bits(17);
  std::normal_distribution<double> normal;
  constexpr int kExperiments = 2000;
  int paired = 0;
  int independent = 0;
  for (int i = 0; i < kExperiments; ++i) {
    std::vector<double> a;
    std::vector<double> b;
    for (int j = 0; j < 15; ++j) {
      a.push_back(normal(bits));
      b.push_back(normal(bits));
    }
    paired += signed_rank_p(a) < 0.05 ? 1 : 0;
    independent += rank_sum_p(a, b) < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(paired) / kExperiments, 0.05, 0.015);
  EXPECT_NEAR(static_cast<double>(independent) / kExperiments, 0.05, 0.015);
}

TEST(Holm, StepsDownFromTheSmallest) {
  // R: p.adjust(c(0.01, 0.04, 0.03, 0.005), "holm")
  const std::vector<double> adjusted = holm_adjusted({0.01, 0.04, 0.03, 0.005});
  EXPECT_DOUBLE_EQ(adjusted[0], 0.03);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[3], 0.02);
  EXPECT_DOUBLE_EQ(holm_adjusted({0.9, 0.8}).front(), 1);
  EXPECT_TRUE(holm_adjusted({}).empty());
}

}  // namespace
}  // namespace raygauge::test_rank_tests
