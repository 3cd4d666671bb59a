// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/order_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace raygauge::test_order_statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(SampleMedian, IsTheMiddleOrTheMeanOfTheTwoInTheMiddle) {
  EXPECT_EQ(sample_median({7}), 7);
  EXPECT_EQ(sample_median({9, 1, 4}), 4);
  EXPECT_EQ(sample_median({9, 1, 4, 5}), 4.5);
  EXPECT_EQ(sample_median({kInfinity, 1, 2}), 2);
  EXPECT_EQ(sample_median({kInfinity, 1}), kInfinity);
}

TEST(OrderStatisticRank, IsThatOfTheTablesOfTheSignTest) {
  // Two-sided critical values of the sign test at 5 %, plus one (Conover 1999, table A3).
  const std::vector<std::pair<std::size_t, std::size_t>> table = {{1, 0},  {5, 0},  {6, 1},   {8, 1},
                                                                  {9, 2},  {11, 2}, {12, 3},  {15, 4},
                                                                  {20, 6}, {25, 8}, {50, 18}, {100, 40}};
  for (const auto& [count, rank] : table) EXPECT_EQ(order_statistic_rank(count), rank) << count;
}

TEST(OrderStatisticRank, FollowsTheNormalApproximationForMoreValuesThanADoubleHasPowersOfTwo) {
  const double count = 100000;
  EXPECT_NEAR(static_cast<double>(order_statistic_rank(100000)), count / 2 - 0.98 * std::sqrt(count), 1.5);
}

TEST(OrderStatisticRank, ReachesTheMiddleForAConfidenceThatAsksNothing) {
  EXPECT_EQ(order_statistic_rank(10, 0.01), 5u);
  EXPECT_EQ(order_statistic_rank(1000, 0.01), 500u);
}

TEST(OrderStatisticInterval, EndsAtValuesOfTheSampleWhateverTheirOrder) {
  std::vector<double> values(20);
  std::iota(values.begin(), values.end(), 1.0);
  std::reverse(values.begin(), values.end());
  const auto interval = order_statistic_interval(values);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->lower, 6);
  EXPECT_EQ(interval->upper, 15);
  EXPECT_FALSE(order_statistic_interval({1, 2, 3, 4, 5}));
  EXPECT_FALSE(order_statistic_interval({}));
}

TEST(OrderStatisticInterval, CoversTheMedianAsOftenAsTheBinomialSays) {
  // 17 values: d = 5, and 1 - 2 P(B < 5) = 1 - 2 * 3214 / 2^17 = 0.95096. Of 20000 samples, three standard
  // deviations are 0.46 %.
  constexpr int kSamples = 20000;
  std::mt19937_64 random(1);
  std::exponential_distribution<double> exponential(1);
  int covered = 0;
  for (int sample = 0; sample < kSamples; ++sample) {
    std::vector<double> values(17);
    std::generate(values.begin(), values.end(), [&] { return exponential(random); });
    const auto interval = order_statistic_interval(values);
    if (interval->lower <= std::log(2.0) && std::log(2.0) <= interval->upper) ++covered;
  }
  EXPECT_NEAR(static_cast<double>(covered) / kSamples, 0.95096, 0.0046);
}

}  // namespace
}  // namespace raygauge::test_order_statistics
