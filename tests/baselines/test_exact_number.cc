// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_number.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace raygauge::test_exact_number {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

TEST(ExactNumber, EveryDoubleIsItsDyadic) {
  for (const double x : {1.0, -0.75, 0.1, 1e300, -kMax, kSmallest, 3 * kSmallest, 0.0}) {
    const Dyadic dyadic = to_dyadic(x);
    EXPECT_EQ(std::ldexp(static_cast<double>(dyadic.mantissa), dyadic.exponent), x);
    EXPECT_TRUE(x == 0 || dyadic.mantissa % 2 != 0) << x;
  }
}

TEST(ExactNumber, ScalesADoubleToAnInteger) {
  EXPECT_EQ(scaled_integer(-0.75, 3), Integer(-6));
  EXPECT_EQ(scaled_integer(kSmallest, 1074), Integer(1));
  EXPECT_EQ(scaled_integer(0.0, 5), Integer(0));
}

TEST(ExactNumber, ScalesARationalBothWays) {
  EXPECT_EQ(scaled_rational(Rational(3, 5), 4), Rational(48, 5));
  EXPECT_EQ(scaled_rational(Rational(3, 5), -2), Rational(3, 20));
}

TEST(ExactNumber, RoundsADoubleToItself) {
  for (const double x : {0.0, 1.0, 0.1, kMax, kSmallest}) {
    const RoundedDoubles rounded = round_nonnegative(Rational(x));
    EXPECT_EQ(rounded.lower, x);
    EXPECT_EQ(rounded.nearest, x);
    EXPECT_EQ(rounded.upper, x);
  }
}

TEST(ExactNumber, RoundsAThirdAsTheDivisionDoes) {
  const RoundedDoubles rounded = round_nonnegative(Rational(1, 3));
  EXPECT_EQ(rounded.nearest, 1.0 / 3.0);
  EXPECT_LT(Rational(rounded.lower), Rational(1, 3));
  EXPECT_EQ(rounded.upper, std::nextafter(rounded.lower, kInf));
}

TEST(ExactNumber, RoundsTiesToEven) {
  const double ulp = std::numeric_limits<double>::epsilon();
  EXPECT_EQ(round_nonnegative(Rational(1) + Rational(ulp) / 2).nearest, 1.0);
  EXPECT_EQ(round_nonnegative(Rational(1) + Rational(3) * Rational(ulp) / 2).nearest, 1 + 2 * ulp);
}

TEST(ExactNumber, RoundsBeyondTheRangeOfDoubles) {
  const RoundedDoubles tiny = round_nonnegative(Rational(kSmallest) / 3);
  EXPECT_EQ(tiny.lower, 0.0);
  EXPECT_EQ(tiny.nearest, 0.0);
  EXPECT_EQ(tiny.upper, kSmallest);
  const RoundedDoubles huge = round_nonnegative(Rational(kMax) * 2);
  EXPECT_EQ(huge.lower, kMax);
  EXPECT_EQ(huge.nearest, kInf);
  EXPECT_EQ(huge.upper, kInf);
  EXPECT_EQ(round_nonnegative(Rational(kMax) + 1).nearest, kMax);
}

RC_GTEST_PROP(ExactNumber, NeighboursEncloseAnyQuotient, (unsigned p, unsigned q)) {
  RC_PRE(q > 0U);
  const Rational x(p, q);
  const RoundedDoubles rounded = round_nonnegative(x);
  RC_ASSERT(Rational(rounded.lower) <= x);
  RC_ASSERT(Rational(rounded.upper) >= x);
  RC_ASSERT(rounded.nearest == static_cast<double>(p) / static_cast<double>(q));
}

}  // namespace
}  // namespace raygauge::test_exact_number
