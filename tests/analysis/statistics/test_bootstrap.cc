// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raygauge/exceptions.h"

namespace raygauge::test_bootstrap {
namespace {

double median_of(const std::vector<double>& values) { return median(values); }

TEST(Bootstrap, GivesTheSameIntervalForTheSameSeed) {
  const std::vector<double> values = {3.14, 1.59, 2.65, 3.58, 9.79, 3.23, 8.46, 2.64, 3.38, 3.27};
  const Interval first = bootstrap_interval(values, mean);
  const Interval again = bootstrap_interval(values, mean);
  EXPECT_EQ(first.lower, again.lower);
  EXPECT_EQ(first.upper, again.upper);
  BootstrapOptions other;
  other.seed = 2;
  EXPECT_NE(bootstrap_interval(values, mean, other).lower, first.lower);
}

TEST(Bootstrap, OfConstantsHasNoWidth) {
  const Interval interval = bootstrap_interval({2, 2, 2}, mean);
  EXPECT_EQ(interval.lower, 2);
  EXPECT_EQ(interval.upper, 2);
}

TEST(Bootstrap, ComesCloseToTheNormalIntervalOfAMean) {
  std::mt19937_64 bits(3);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(normal(bits));
  double variance = 0;
  for (const double x : values) variance += (x - mean(values)) * (x - mean(values)) / 399;
  const double half = 1.959964 * std::sqrt(variance / 400);
  const Interval interval = bootstrap_interval(values, mean);
  // 2000 resamples leave the ends uncertain by a few per cent of the width.
  EXPECT_NEAR(interval.lower, mean(values) - half, 0.1 * half);
  EXPECT_NEAR(interval.upper, mean(values) + half, 0.1 * half);
}

TEST(Bootstrap, CoversTheMedianIn93To97Percent) {
  std::mt19937_64 bits(5);
  std::normal_distribution<double> normal;
  BootstrapOptions options;
  options.resamples = 400;
  int covered = 0;
  constexpr int kExperiments = 1000;
  for (int i = 0; i < kExperiments; ++i) {
    std::vector<double> values;
    for (int j = 0; j < 30; ++j) values.push_back(normal(bits));
    options.seed = static_cast<std::uint64_t>(i);
    const Interval interval = bootstrap_interval(values, median_of, options);
    covered += interval.lower <= 0 && 0 <= interval.upper ? 1 : 0;
  }
  EXPECT_GE(covered, 930);
  EXPECT_LE(covered, 970);
}

TEST(Bootstrap, RefusesWhatMakesNoInterval) {
  EXPECT_THROW(bootstrap_interval({}, mean), EmptySetError);
  BootstrapOptions options;
  options.resamples = 0;
  EXPECT_THROW(bootstrap_interval({1}, mean, options), InvalidParameterError);
  options = {};
  options.confidence = 1;
  EXPECT_THROW(bootstrap_interval({1}, mean, options), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_bootstrap
