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
  const Rational unit = Rational(0x1p-106), loss = 3 * unit;
  Random random(33);
  for (int trial = 0; trial < 2000; ++trial) {
    const DoubleDouble a = two_product(wild(random, 20), wild(random, 20));
    const DoubleDouble b = two_product(wild(random, 20), wild(random, 20));
    const double c = wild(random, 20);
    const Rational magnitude = abs(exact(a)) + abs(exact(b));
    EXPECT_LE(abs(exact(a + b) - (exact(a) + exact(b))), loss * magnitude);
    EXPECT_LE(abs(exact(a - b) - (exact(a) - exact(b))), loss * magnitude);
    EXPECT_LE(abs(exact(a * c) - exact(a) * Rational(c)), 5 * unit * abs(exact(a) * Rational(c)));
  }
}

// Sums whose high parts cancel, all of them or down to a few bits.
TEST(DoubleDouble, LosesNoMoreThanItSaysWhereTermsCancel) {
  const Rational loss = 3 * Rational(0x1p-106);
  Random random(35);
  for (int trial = 0; trial < 2000; ++trial) {
    const DoubleDouble a = two_product(wild(random, 20), wild(random, 20));
    const double near = a.high * (1 + static_cast<double>(random() % 5) * 0x1p-52);
    const DoubleDouble b = two_sum(-near, wild(random, 3) * 0x1p-54 * near);
    const Rational magnitude = abs(exact(a)) + abs(exact(b));
    EXPECT_LE(abs(exact(a + b) - (exact(a) + exact(b))), loss * magnitude);
    EXPECT_EQ((a + b).rounded(), (a + b).high);
  }
}

TEST(DoubleDouble, KeepsWhatCancellationLeaves) {
  const DoubleDouble sum = (two_sum(1, 0x1p-80) - DoubleDouble{1, 0}) + 0x1p-90;
  EXPECT_EQ(exact(sum), Rational(0x1p-80) + Rational(0x1p-90));
  EXPECT_EQ(sum.rounded(), 0x1p-80 + 0x1p-90);
}

TEST(DoubleDouble, MultipliesDividesAndTakesRootsAsItSays) {
  Random random(34);
  const Rational unit = Rational(0x1p-106);
  const auto magnitude = [](const Rational& x) { return x < 0 ? Rational(-x) : x; };
  for (int trial = 0; trial < 2000; ++trial) {
    const DoubleDouble a = two_sum(wild(random, 40), wild(random, 40) * 0x1p-60);
    const DoubleDouble b = two_sum(wild(random, 40), wild(random, 40) * 0x1p-60);
    const Rational product = exact(a) * exact(b);
    EXPECT_LE(magnitude(exact(a * b) - product), 5 * unit * magnitude(product));
    const Rational quotient = exact(a) / exact(b);
    EXPECT_LE(magnitude(exact(a / b) - quotient), 12 * unit * magnitude(quotient));
    const DoubleDouble positive = a.high < 0 ? -a : a;
    const Rational root = exact(sqrt(positive));
    EXPECT_LE(magnitude(root * root - exact(positive)), 2 * 5 * unit * exact(positive));
    EXPECT_EQ(a < b, exact(a) < exact(b));
    EXPECT_EQ(a >= b, exact(a) >= exact(b));
  }
}

}  // namespace
}  // namespace raygauge::test_double_double
