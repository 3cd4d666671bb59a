// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/exact_sum.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "tests/engine/rational.h"

namespace raygauge::test_exact_sum {
namespace {

TEST(ExactSum, OfNothingIsZero) { EXPECT_TRUE(ExactSum().is_zero()); }

TEST(ExactSum, SeesATermThatRoundingSwallows) {
  ExactSum sum;
  sum.add(1e300);
  sum.add(1e-300);
  sum.add(-1e300);
  EXPECT_FALSE(sum.is_zero());
  sum.add(-1e-300);
  EXPECT_TRUE(sum.is_zero());
}

TEST(ExactSum, SeesTheLastBitOfAProduct) {
  const double a = 1 + std::numeric_limits<double>::epsilon();
  ExactSum sum;
  sum.add_product(a, a);
  sum.add(-(a * a));
  EXPECT_FALSE(sum.is_zero());
}

TEST(ExactSum, DoesNotCallAnUnderflowedProductZero) {
  ExactSum sum;
  sum.add_product(1e-200, 1e-200);
  EXPECT_FALSE(sum.is_zero());
}

TEST(ExactSum, DoesNotCallAnOverflowedSumZero) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  ExactSum sum;
  sum.add_product(kLargest, 2);
  sum.add_product(-kLargest, 2);
  EXPECT_FALSE(sum.is_zero());
}

RC_GTEST_PROP(ExactSumProperty, AgreesWithRationalArithmetic,
              (const std::vector<std::pair<double, double>>& products)) {
  ExactSum sum;
  Rational exact = 0;
  for (const auto& [a, b] : products) {
    sum.add_product(a, b);
    exact += Rational(a) * Rational(b);
  }
  if (sum.is_zero()) RC_ASSERT(exact == 0);
  const ExactSum::Rounded rounded = sum.rounded();
  if (std::isfinite(rounded.error)) {
    RC_ASSERT(abs(Rational(rounded.value) - exact) <= Rational(rounded.error));
  }
}

TEST(ExactSum, RoundsWhatCancellationLeaves) {
  ExactSum sum;
  sum.add_product(0x1p60 + 1, 3);
  sum.add(-0x1p60 * 3);
  sum.add(0x1p-60);
  EXPECT_NEAR(sum.rounded().value, 0x1p-60, sum.rounded().error);
  EXPECT_LT(sum.rounded().error, 1e-33);
}

RC_GTEST_PROP(ExactSumProperty, ComesBackToZeroWhenEveryProductIsTakenOff,
              (const std::vector<std::pair<int, int>>& products)) {
  ExactSum sum;
  for (const auto& [a, b] : products) sum.add_product(a / 3.0, b / 7.0);
  for (const auto& [a, b] : products) sum.add_product(-a / 3.0, b / 7.0);
  RC_ASSERT(sum.is_zero());
}

}  // namespace
}  // namespace raygauge::test_exact_sum
