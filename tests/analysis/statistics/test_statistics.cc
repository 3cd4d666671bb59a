// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "raygauge/exceptions.h"

namespace raygauge::test_statistics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-12;

std::vector<double> lognormal_sample(std::mt19937_64& bits, std::size_t count) {
  std::normal_distribution<double> normal;
  std::vector<double> sample;
  for (std::size_t i = 0; i < count; ++i) sample.push_back(std::exp(normal(bits)));
  return sample;
}

/// Fraction of `experiments` in which `covers` holds.
template <class Covers>
double coverage(int experiments, const Covers& covers) {
  int hits = 0;
  for (int i = 0; i < experiments; ++i) hits += covers() ? 1 : 0;
  return static_cast<double>(hits) / experiments;
}

// 4000 experiments tell a coverage to ±0.007 (two standard errors), well within 93 … 97 %.
constexpr int kExperiments = 4000;

TEST(Quantile, FollowsTypeSevenOfHyndmanAndFan) {
  // R: quantile(c(1, 2, 3, 4, 10), c(0.1, 0.25, 0.5, 0.9), type = 7)
  const std::vector<double> values = {10, 3, 1, 4, 2};
  EXPECT_NEAR(quantile(values, 0.1), 1.4, kRounding);
  EXPECT_NEAR(quantile(values, 0.25), 2, kRounding);
  EXPECT_NEAR(quantile(values, 0.9), 7.6, kRounding);
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 1), 10);
  EXPECT_EQ(median(values), 3);
  EXPECT_EQ(median({1, 2, 3, 4}), 2.5);
  EXPECT_EQ(median({7}), 7);
}

TEST(Quantile, TakesInfinityForALargeValue) {
  EXPECT_EQ(median({1, 2, kInfinity}), 2);
  EXPECT_EQ(median({1, 2, kInfinity, kInfinity}), kInfinity);
  EXPECT_EQ(median({1, kInfinity, kInfinity, kInfinity}), kInfinity);
}

TEST(Quantile, RefusesNothingNaNAndOrdersOutOfRange) {
  EXPECT_THROW(median({}), EmptySetError);
  EXPECT_THROW(median({1, std::nan("")}), NonFiniteError);
  EXPECT_THROW(quantile({1}, 1.5), InvalidParameterError);
  EXPECT_THROW(quantile({1}, std::nan("")), InvalidParameterError);
}

TEST(GeometricMean, IsTheRootOfTheProduct) {
  EXPECT_NEAR(geometric_mean({1, 10, 100}), 10, 10 * kRounding);
  EXPECT_NEAR(geometric_mean({0.5, 2}), 1, kRounding);
  EXPECT_EQ(geometric_mean({0, 5}), 0);
  EXPECT_EQ(geometric_mean({kInfinity, 5}), kInfinity);
  EXPECT_THROW(geometric_mean({-1, 5}), InvalidParameterError);
  EXPECT_THROW(geometric_mean({}), EmptySetError);
}

TEST(ShiftedGeometricMean, IsTheGeometricMeanOfTheShiftedValuesLessTheShift) {
  EXPECT_NEAR(shifted_geometric_mean({0, 8}, 1), 2, 10 * kRounding);  // √(1 · 9) - 1
  EXPECT_EQ(shifted_geometric_mean({kInfinity, 5}, 10), kInfinity);
  EXPECT_THROW(shifted_geometric_mean({-1, 5}, 10), InvalidParameterError);
  EXPECT_THROW(shifted_geometric_mean({1, 5}, 0), InvalidParameterError);
}

TEST(Mean, IsTheSumOverTheCount) { EXPECT_EQ(mean({1, 2, 6}), 3); }

TEST(MedianInterval, InterpolatesAsHettmanspergerAndSheatherDo) {
  // n = 10: γ_2 = 1 - 22/1024, γ_3 = 1 - 112/1024, I = (γ_2 - 0.95) / (γ_2 - γ_3) = 29.2/90,
  // λ = 8 I / (2 + 6 I) = 233.6 / 355.2.
  const Interval interval = median_interval({10, 9, 8, 7, 6, 5, 4, 3, 2, 1});
  EXPECT_NEAR(interval.lower, 2 + 233.6 / 355.2, 1e-10);
  EXPECT_NEAR(interval.upper, 9 - 233.6 / 355.2, 1e-10);
  EXPECT_EQ(interval.confidence, 0.95);
}

TEST(MedianInterval, IsTheRangeWhereThereAreTooFewValues) {
  const Interval five = median_interval({5, 1, 2, 3, 4});
  EXPECT_EQ(five.lower, 1);
  EXPECT_EQ(five.upper, 5);
  EXPECT_NEAR(five.confidence, 1 - 2.0 / 32, kRounding);
  EXPECT_EQ(median_interval({3}).confidence, 0);
}

TEST(MedianInterval, NestsAndReachesTheMedianForSmallConfidence) {
  const std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  double width = kInfinity;
  for (const double confidence : {0.99, 0.95, 0.9, 0.8, 0.5, 0.2, 0.05}) {
    const Interval interval = median_interval(values, confidence);
    EXPECT_LE(interval.lower, 5);
    EXPECT_GE(interval.upper, 5);
    EXPECT_LT(interval.upper - interval.lower, width) << confidence;
    width = interval.upper - interval.lower;
  }
}

TEST(MedianInterval, CoversTheMedianOfASkewedDistributionIn93To97Percent) {
  std::mt19937_64 bits(7);
  for (const std::size_t count : {6, 7, 10, 15, 20, 21, 50}) {
    const double covered = coverage(kExperiments, [&] {
      const Interval interval = median_interval(lognormal_sample(bits, count));
      return interval.lower <= 1 && 1 <= interval.upper;
    });
    EXPECT_GE(covered, 0.93) << count;
    EXPECT_LE(covered, 0.97) << count;
  }
}

TEST(MedianInterval, RefusesAConfidenceThatIsNone) {
  EXPECT_THROW(median_interval({1, 2}, 0), InvalidParameterError);
  EXPECT_THROW(median_interval({1, 2}, 1), InvalidParameterError);
}

TEST(RatioOfMedians, OfConstantsIsTheirRatioWithoutWidth) {
  const Ratio ratio = ratio_of_medians(std::vector<double>(8, 3.0), std::vector<double>(9, 12.0));
  EXPECT_EQ(ratio.ratio, 0.25);
  EXPECT_NEAR(ratio.interval.lower, 0.25, kRounding);
  EXPECT_NEAR(ratio.interval.upper, 0.25, kRounding);
}

TEST(RatioOfMedians, CoversTheTrueRatioIn93To97Percent) {
  std::mt19937_64 bits(11);
  for (const std::size_t count : {20, 40}) {
    const double covered = coverage(kExperiments, [&] {
      const Ratio ratio = ratio_of_medians(lognormal_sample(bits, count), lognormal_sample(bits, count + 5));
      return ratio.interval.lower <= 1 && 1 <= ratio.interval.upper;
    });
    EXPECT_GE(covered, 0.93) << count;
    EXPECT_LE(covered, 0.97) << count;
  }
}

TEST(RatioOfMedians, IsInfiniteWhereTheNumeratorIsMostlyUnsolved) {
  const Ratio ratio = ratio_of_medians({1, kInfinity, kInfinity}, {1, 2, 3});
  EXPECT_EQ(ratio.ratio, kInfinity);
  EXPECT_EQ(ratio.interval.upper, kInfinity);
}

TEST(RatioOfMedians, RefusesTimesThatAreNotPositive) {
  EXPECT_THROW(ratio_of_medians({1, 0}, {1}), InvalidParameterError);
  EXPECT_THROW(ratio_of_medians({1}, {}), EmptySetError);
}

}  // namespace
}  // namespace raygauge::test_statistics
