// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/big_integer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/engine/rational.h"

namespace raygauge::test_big_integer {
namespace {

using Integer = boost::multiprecision::mpz_int;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A number of many limbs, Σ_k term_k 2^(40 k), here and in the oracle's arithmetic.
struct Pair {
  BigInteger tested;
  Integer oracle = 0;
};

Pair number(const std::vector<std::int64_t>& terms) {
  Pair pair;
  for (const std::int64_t term : terms) {
    constexpr int kPlace = 40;
    pair.tested.shift_left(kPlace);
    pair.oracle *= Integer(1) << kPlace;
    const auto rounded = static_cast<double>(term);
    BigInteger addend;
    addend.assign_scaled(rounded, 0);
    pair.tested.add(addend);
    pair.oracle += Integer(rounded);
  }
  return pair;
}

// Equality without a conversion that is itself under test: the oracle's number is built bit by bit.
BigInteger from_oracle(const Integer& value) {
  BigInteger result;
  const Integer magnitude = abs(value);
  for (auto bit = static_cast<std::int64_t>(magnitude == 0 ? 0 : msb(magnitude) + 1); bit-- > 0;) {
    result.shift_left(1);
    BigInteger one;
    one.assign_scaled(1, 0);
    if (bit_test(magnitude, static_cast<unsigned>(bit))) result.add(one);
  }
  if (value < 0) result.negate();
  return result;
}

RC_GTEST_PROP(BigIntegerProperty, AddsSubtractsAndMultipliesAsTheOracle,
              (const std::vector<std::int64_t>& left, const std::vector<std::int64_t>& right)) {
  const Pair a = number(left);
  const Pair b = number(right);
  BigInteger sum = a.tested;
  sum.add(b.tested);
  RC_ASSERT(sum == from_oracle(a.oracle + b.oracle));
  BigInteger difference = a.tested;
  difference.subtract(b.tested);
  RC_ASSERT(difference == from_oracle(a.oracle - b.oracle));
  BigInteger product;
  product.assign_product(a.tested, b.tested);
  RC_ASSERT(product == from_oracle(a.oracle * b.oracle));
}

RC_GTEST_PROP(BigIntegerProperty, OrdersAsTheOracle,
              (const std::vector<std::int64_t>& left, const std::vector<std::int64_t>& right)) {
  const Pair a = number(left);
  const Pair b = number(right);
  RC_ASSERT((a.tested < b.tested) == (a.oracle < b.oracle));
  RC_ASSERT((a.tested == b.tested) == (a.oracle == b.oracle));
  RC_ASSERT(a.tested.sign() == a.oracle.sign());
}

RC_GTEST_PROP(BigIntegerProperty, DividesWhatItMultiplied,
              (const std::vector<std::int64_t>& left, const std::vector<std::int64_t>& right)) {
  const Pair a = number(left);
  Pair b = number(right);
  RC_PRE(!b.tested.is_zero());
  if (b.tested.sign() < 0) b.tested.negate();
  ExactDivisor divisor;
  divisor.assign(b.tested);
  BigInteger quotient;
  quotient.assign_product(a.tested, b.tested);
  divisor.divide(quotient);
  RC_ASSERT(quotient == a.tested);
}

RC_GTEST_PROP(BigIntegerProperty, IsApproximatedToAHundredBits, (const std::vector<std::int64_t>& terms)) {
  const Pair a = number(terms);
  const ScaledDouble approximate = a.tested.approximate();
  RC_ASSERT(std::abs(approximate.exponent) < 10000);
  Rational value = Rational(approximate.mantissa.high) + Rational(approximate.mantissa.low);
  value *= Rational(Integer(1) << static_cast<unsigned>(approximate.exponent));
  const Rational error = abs(value - Rational(a.oracle));
  RC_ASSERT(error * Rational(0x1p100) <= abs(Rational(a.oracle)));
}

RC_GTEST_PROP(RoundedRatioProperty, EnclosesTheRatioBetweenNeighbours,
              (const std::vector<std::int64_t>& left, const std::vector<std::int64_t>& right)) {
  Pair a = number(left);
  Pair b = number(right);
  RC_PRE(!b.tested.is_zero());
  if (a.tested.sign() < 0) a.tested.negate();
  if (b.tested.sign() < 0) b.tested.negate();
  const RoundedRatio rounded = rounded_ratio(a.tested, b.tested, 0);
  const Rational ratio = abs(Rational(a.oracle)) / abs(Rational(b.oracle));
  RC_ASSERT(encloses(rounded.below, rounded.above, ratio));
  RC_ASSERT(rounded.above <= std::nextafter(rounded.below, kInfinity));
  RC_ASSERT((rounded.below == rounded.above) == (Rational(rounded.below) == ratio));
  if (std::isnormal(rounded.above) && std::isfinite(rounded.above)) {
    RC_ASSERT(abs(Rational(rounded.nearest) - ratio) * 2 <=
              Rational(rounded.above) - Rational(rounded.below));
  }
}

TEST(BigInteger, HoldsADoubleOfAnySize) {
  BigInteger smallest;
  smallest.assign_scaled(std::numeric_limits<double>::denorm_min(), 1074);
  EXPECT_EQ(smallest, from_oracle(1));
  BigInteger largest;
  largest.assign_scaled(-std::numeric_limits<double>::max(), 0);
  EXPECT_EQ(largest, from_oracle(Integer(-std::numeric_limits<double>::max())));
  EXPECT_EQ(largest.bit_length(), 1024);
}

TEST(BigInteger, HasNoNegativeZero) {
  BigInteger one;
  one.assign_scaled(-1, 0);
  one.subtract(one);
  EXPECT_TRUE(one.is_zero());
  one.negate();
  EXPECT_EQ(one, BigInteger());
}

TEST(RoundedRatio, IsExactWhereItCanBe) {
  BigInteger three;
  three.assign_scaled(3, 0);
  BigInteger four;
  four.assign_scaled(4, 0);
  const RoundedRatio rounded = rounded_ratio(three, four, 10);
  EXPECT_EQ(rounded.below, 768);
  EXPECT_EQ(rounded.above, 768);
}

TEST(RoundedRatio, EnclosesWhatIsJustBelowTheNormalRange) {
  BigInteger one;
  one.assign_scaled(1, 0);
  BigInteger denominator;
  denominator.assign_scaled(0x1p1022, 0);
  denominator.add(one);
  const double smallest_normal = std::numeric_limits<double>::min();
  const RoundedRatio rounded = rounded_ratio(one, denominator, 0);
  EXPECT_EQ(rounded.below, std::nextafter(smallest_normal, 0));
  EXPECT_EQ(rounded.above, smallest_normal);
}

TEST(RoundedRatio, LeavesTheRangeOfDoublesOnTheRightSide) {
  BigInteger one;
  one.assign_scaled(1, 0);
  BigInteger three;
  three.assign_scaled(3, 0);
  const RoundedRatio huge = rounded_ratio(one, three, 5000);
  EXPECT_EQ(huge.below, std::numeric_limits<double>::max());
  EXPECT_EQ(huge.above, kInfinity);
  const RoundedRatio tiny = rounded_ratio(one, three, -5000);
  EXPECT_EQ(tiny.below, 0);
  EXPECT_EQ(tiny.above, std::numeric_limits<double>::denorm_min());
}

}  // namespace
}  // namespace raygauge::test_big_integer
