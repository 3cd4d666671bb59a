// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/randomisation_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace raygauge::test_randomisation_test {
namespace {

TEST(RandomisationTest, OfOneSeriesCountsTheSignsThatReachItsMean) {
  // All five differences are equal: of 2^5 choices of signs one has a mean as large.
  const RandomisationResult result = test_pairs({{"b", "m", {0.1, 0.1, 0.1, 0.1, 0.1}}}, {"m"});
  EXPECT_DOUBLE_EQ(result.series[0], 1.0 / 32);
  EXPECT_DOUBLE_EQ(result.groups[0], 1.0 / 32);
  // |3 - 2| of 5: means of at least 0.02 have 3, 4 or 5 positive signs.
  const RandomisationResult mixed = test_pairs({{"b", "m", {0.1, -0.1, 0.1, -0.1, 0.1}}}, {});
  EXPECT_DOUBLE_EQ(mixed.series[0], 16.0 / 32);
}

TEST(RandomisationTest, OfRunsCountsTheLabelsThatSeparateThem) {
  // Of the 70 ways to call 4 of 8 runs new, one has the four slow ones.
  const RandomisationResult result = test_runs({{"b", "m", {0, 0.01, 0.02, 0.03, 1, 1, 1, 1}}}, 4, {"m"});
  EXPECT_DOUBLE_EQ(result.series[0], 1.0 / 70);
}

TEST(RandomisationTest, OneDisturbedPairDoesNotHideAChange) {
  std::vector<RunSeries> series;
  for (const std::string block : {"a", "b", "c", "d"})
    series.push_back({block, "m", {0.1, 0.11, 0.09, 0.1, 0.1}});
  series[2].values[3] = -5;
  EXPECT_LT(test_pairs(series, {"m"}).groups[0], 0.01);
}

/// Blocks of series that one disturbance moves together.
std::vector<RunSeries> disturbed(std::mt19937_64& random, bool paired) {
  std::cauchy_distribution<double> heavy(0, 0.03);
  std::vector<RunSeries> series;
  for (const std::string block : {"a", "b", "c"}) {
    std::vector<double> shared(paired ? 5 : 8);
    for (double& x : shared) x = heavy(random);
    for (const std::string group : {"m1", "m2"}) {
      std::vector<double> values = shared;
      for (double& x : values) x += 0.2 * heavy(random);
      series.push_back({block, group, values});
    }
  }
  return series;
}

TEST(RandomisationTest, KeepsItsLevelOverAllSeriesUnderHeavyTailsThatSeriesShare) {
  std::mt19937_64 random(1);
  RandomisationOptions options;
  options.draws = 199;
  for (const bool paired : {true, false}) {
    int alarms = 0;
    constexpr int kTries = 400;
    for (int t = 0; t < kTries; ++t) {
      const std::vector<RunSeries> series = disturbed(random, paired);
      const RandomisationResult result =
          paired ? test_pairs(series, {"m1", "m2"}, options) : test_runs(series, 4, {"m1", "m2"}, options);
      double least = 1;
      for (const double p : result.series) least = std::min(least, p);
      for (const double p : result.groups) least = std::min(least, p);
      alarms += least <= 0.05 ? 1 : 0;
    }
    // One sided it is 5 % each way: 40 of 400, and two standard errors.
    EXPECT_LE(alarms, 52) << paired;
  }
}

TEST(RandomisationTest, MissingPairsCountAsNoDifference) {
  const RandomisationResult result = test_pairs({{"b", "m", {0.1, NAN, 0.1, 0.1, 0.1}}}, {});
  EXPECT_DOUBLE_EQ(result.series[0], 2.0 / 32);
}

}  // namespace
}  // namespace raygauge::test_randomisation_test
