// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/double_double.h"

#include <gtest/gtest.h>

#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_double_double {
namespace {

Rational exact(const DoubleDouble& value) { return Rational(value.high) + Rational(value.low); }

// A double of random sign, mantissa and exponent in [-range, range].
double wild(Random& random, int range) {
  std::normal_distribution<double> normal;
  return std::ldexp(normal(random),
                    static_cast<int>(random() % static_cast<unsigned>(2 * range + 1)) - range);
}

TEST(DoubleDouble, AddsTwoDoublesWithoutError) {
  Random random(31);
  for (int trial = 0; trial < 2000; ++trial) {
    const double a = wild(random, 200);
    const double b = wild(random, 200);
    EXPECT_EQ(exact(two_sum(a, b)), Rational(a) + Rational(b));
  }
}

TEST(DoubleDouble, MultipliesTwoDoublesWithoutError) {
  Random random(32);
  for (int trial = 0; trial < 2000; ++trial) {
    const double a = wild(random, 200);
    const double b = wild(random, 200);
    EXPECT_EQ(exact(two_product(a, b)), Rational(a) * Rational(b));
  }
}

TEST(DoubleDouble, LosesNoMoreThanItSaysInSumsAndProducts) {
  const Rational loss = Rational(std::ldexp(1.0, -102));
  Random random(33);
  for (int trial = 0; trial < 2000; ++trial) {
    const DoubleDouble a = two_product(wild(random, 20), wild(random, 20));
    const DoubleDouble b = two_product(wild(random, 20), wild(random, 20));
    const double c = wild(random, 20);
    const Rational magnitude = abs(exact(a)) + abs(exact(b));
    EXPECT_LE(abs(exact(a + b) - (exact(a) + exact(b))), loss * magnitude);
    EXPECT_LE(abs(exact(a - b) - (exact(a) - exact(b))), loss * magnitude);
    EXPECT_LE(abs(exact(a * c) - exact(a) * Rational(c)), loss * abs(exact(a) * Rational(c)));
  }
}

TEST(DoubleDouble, KeepsWhatCancellationLeaves) {
  const DoubleDouble sum = (two_sum(1, 0x1p-80) - DoubleDouble{1, 0}) + 0x1p-90;
  EXPECT_EQ(exact(sum), Rational(0x1p-80) + Rational(0x1p-90));
  EXPECT_EQ(sum.rounded(), 0x1p-80 + 0x1p-90);
}

TEST(DoubleDouble, MultipliesDividesAndTakesRootsToAHundredBits) {
  Random random(34);
  const Rational share = Rational(0x1p-100);
  const auto magnitude = [](const Rational& x) { return x < 0 ? Rational(-x) : x; };
  for (int trial = 0; trial < 2000; ++trial) {
    const DoubleDouble a = two_sum(wild(random, 40), wild(random, 40) * 0x1p-60);
    const DoubleDouble b = two_sum(wild(random, 40), wild(random, 40) * 0x1p-60);
    const Rational product = exact(a) * exact(b);
    EXPECT_LE(magnitude(exact(a * b) - product), share * magnitude(product));
    const Rational quotient = exact(a) / exact(b);
    EXPECT_LE(magnitude(exact(a / b) - quotient), share * magnitude(quotient));
    const DoubleDouble positive = a.high < 0 ? -a : a;
    const Rational root = exact(sqrt(positive));
    EXPECT_LE(magnitude(root * root - exact(positive)), share * 4 * exact(positive));
    EXPECT_EQ(a < b, exact(a) < exact(b));
    EXPECT_EQ(a >= b, exact(a) >= exact(b));
  }
}

}  // namespace
}  // namespace raygauge::test_double_double
