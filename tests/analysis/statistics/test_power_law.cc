// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raygauge/exceptions.h"

namespace raygauge::test_power_law {
namespace {

TEST(PowerLaw, FindsAnExactOne) {
  const PowerLaw fit = fit_power_law({1, 2, 4, 8}, {3, 12, 48, 192});
  EXPECT_NEAR(fit.exponent, 2, 1e-12);
  EXPECT_NEAR(fit.factor, 3, 1e-12);
  EXPECT_NEAR(fit.r_squared, 1, 1e-12);
  EXPECT_NEAR(fit.exponent_interval.upper - fit.exponent_interval.lower, 0, 1e-6);
  EXPECT_EQ(fit.points, 4U);
}

TEST(PowerLaw, AgreesWithLeastSquaresByHand) {
  // Logarithms (0, 1), (1, 2), (2, 4): slope 3/2, intercept 5/6, RSS 1/6, s_uu = 2, t(0.975; 1) = 12.7062.
  const double e = std::exp(1.0);
  const PowerLaw fit = fit_power_law({1, e, e * e}, {e, e * e, std::exp(4.0)});
  EXPECT_NEAR(fit.exponent, 1.5, 1e-12);
  EXPECT_NEAR(fit.factor, std::exp(5.0 / 6), 1e-12);
  EXPECT_NEAR(fit.residual, std::sqrt(1.0 / 6), 1e-12);
  EXPECT_NEAR(fit.r_squared, 27.0 / 28, 1e-12);
  EXPECT_NEAR(fit.exponent_interval.upper - 1.5, 12.7062 * std::sqrt(1.0 / 12), 1e-4);
  const double intercept_half = 12.7062 * std::sqrt(1.0 / 6 * (1.0 / 3 + 1.0 / 2));
  EXPECT_NEAR(std::log(fit.factor_interval.upper), 5.0 / 6 + intercept_half, 1e-4);
}

TEST(PowerLaw, CoversTheTrueExponentIn93To97Percent) {
  std::mt19937_64 bits(13);
  std::normal_distribution<double> normal;
  constexpr int kExperiments = 4000;
  int covered = 0;
  for (int i = 0; i < kExperiments; ++i) {
    std::vector<double> x;
    std::vector<double> y;
    for (int j = 1; j <= 8; ++j) {
      x.push_back(200.0 * j);
      y.push_back(std::pow(200.0 * j, 0.4) * std::exp(0.1 * normal(bits)));
    }
    const PowerLaw fit = fit_power_law(x, y);
    covered += fit.exponent_interval.lower <= 0.4 && 0.4 <= fit.exponent_interval.upper ? 1 : 0;
  }
  EXPECT_GE(covered, 0.93 * kExperiments);
  EXPECT_LE(covered, 0.97 * kExperiments);
}

TEST(PowerLaw, ThroughTwoPointsHasNoFiniteInterval) {
  const PowerLaw fit = fit_power_law({1, 10}, {1, 100});
  EXPECT_NEAR(fit.exponent, 2, 1e-12);
  EXPECT_TRUE(std::isinf(fit.exponent_interval.upper));
}

TEST(PowerLaw, RefusesWhatHasNoLogarithmOrNoSlope) {
  EXPECT_THROW(fit_power_law({1, 2}, {1}), DimensionMismatchError);
  EXPECT_THROW(fit_power_law({1, 2}, {1, 0}), InvalidParameterError);
  EXPECT_THROW(fit_power_law({1, 2}, {1, INFINITY}), InvalidParameterError);
  EXPECT_THROW(fit_power_law({3, 3}, {1, 2}), InvalidParameterError);
  EXPECT_THROW(fit_power_law({3}, {1}), InvalidParameterError);
  EXPECT_THROW(fit_power_law({1, 2}, {1, 2}, 1), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_power_law
