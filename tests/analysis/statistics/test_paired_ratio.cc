// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/paired_ratio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "raygauge/exceptions.h"

namespace raygauge::test_paired_ratio {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Times of the same instances, which differ from each other far more than their two measurements do; the
/// first ones are `factor` times the second but for 5 % of noise in each.
struct Twins {
  std::vector<double> first;
  std::vector<double> second;
};

Twins twins(std::mt19937_64& bits, std::size_t count, double factor) {
  std::normal_distribution<double> normal;
  constexpr double kNoise = 0.05;
  Twins result;
  for (std::size_t i = 0; i < count; ++i) {
    const double instance = normal(bits);
    result.first.push_back(factor * std::exp(instance + kNoise * normal(bits)));
    result.second.push_back(std::exp(instance + kNoise * normal(bits)));
  }
  return result;
}

TEST(PairedRatio, IsTheMedianOfTheRatios) {
  const Ratio ratio = paired_ratio({2, 30, 400, 5, 6, 7}, {1, 10, 100, 1, 1, 1});
  EXPECT_NEAR(ratio.ratio, std::sqrt(4.0 * 5.0), 1e-12);  // median of the logarithms: the geometric middle
  // Of 6 values γ_1 = 1 - 2 / 64 and γ_2 = 1 - 14 / 64, so that I = 0.1 and λ = 5 I / (1 + 4 I) = 5/14: the
  // ends lie so far from the outermost ratio to the next, on the scale of logarithms.
  const double lambda = 5.0 / 14;
  EXPECT_NEAR(ratio.interval.lower, 2 * std::pow(3.0 / 2, lambda), 1e-12);
  EXPECT_NEAR(ratio.interval.upper, 7 * std::pow(6.0 / 7, lambda), 1e-12);
}

TEST(PairedRatio, CoversTheTrueRatioIn93To97PercentOfAThousandExperiments) {
  std::mt19937_64 bits(3);
  constexpr int kExperiments = 1000;
  constexpr double kTruth = 1.25;
  for (const std::size_t count : {10, 20}) {
    int covered = 0;
    for (int i = 0; i < kExperiments; ++i) {
      const Twins sample = twins(bits, count, kTruth);
      const Interval interval = paired_ratio(sample.first, sample.second).interval;
      covered += interval.lower <= kTruth && kTruth <= interval.upper ? 1 : 0;
    }
    EXPECT_GE(covered, 930) << count;
    EXPECT_LE(covered, 970) << count;
  }
}

TEST(PairedRatio, IsNarrowerThanThatOfIndependentSamplesWhereInstancesDiffer) {
  std::mt19937_64 bits(5);
  const Twins sample = twins(bits, 20, 1);
  const Interval paired = paired_ratio(sample.first, sample.second).interval;
  const Interval independent = ratio_of_medians(sample.first, sample.second).interval;
  EXPECT_LT(paired.upper / paired.lower, std::sqrt(independent.upper / independent.lower));
}

TEST(PairedRatio, LeavesOutWhatNeitherSolvedAndKeepsWhatOneSolved) {
  EXPECT_DOUBLE_EQ(paired_ratio({2, kInfinity}, {1, kInfinity}).ratio, 2);
  EXPECT_EQ(paired_ratio({kInfinity}, {1}).ratio, kInfinity);
  EXPECT_EQ(paired_ratio({1}, {kInfinity}).ratio, 0);
  EXPECT_TRUE(std::isnan(paired_ratio({kInfinity}, {kInfinity}).ratio));
}

TEST(PairedRatio, RefusesUnequalLengthsAndTimesThatAreNotPositive) {
  EXPECT_THROW(paired_ratio({1}, {1, 2}), DimensionMismatchError);
  EXPECT_THROW(paired_ratio({0}, {1}), InvalidParameterError);
  EXPECT_THROW(paired_ratio({1}, {-1}), InvalidParameterError);
}

TEST(GeometricMeanRatio, HasStudentsIntervalAndTest) {
  // R: t.test(c(0.1, 0.2, 0.3, 0.4)): mean 0.25, 95 % interval 0.0445740 .. 0.4554260, p = 0.03046
  const TestedRatio tested = geometric_mean_ratio({0.1, 0.2, 0.3, 0.4});
  EXPECT_NEAR(std::log(tested.ratio.ratio), 0.25, 1e-12);
  EXPECT_NEAR(std::log(tested.ratio.interval.lower), 0.0445740, 1e-6);
  EXPECT_NEAR(std::log(tested.ratio.interval.upper), 0.4554260, 1e-6);
  EXPECT_NEAR(tested.p, 0.03046, 1e-5);
}

TEST(GeometricMeanRatio, ProvesNothingFromOneCell) {
  EXPECT_EQ(geometric_mean_ratio({0.5}).p, 1);
  EXPECT_EQ(geometric_mean_ratio({0.5}).ratio.interval.upper, kInfinity);
  EXPECT_TRUE(std::isnan(geometric_mean_ratio({}).ratio.ratio));
  EXPECT_DOUBLE_EQ(geometric_mean_ratio({0, 0, kInfinity}).p, 1);
}

}  // namespace
}  // namespace raygauge::test_paired_ratio
