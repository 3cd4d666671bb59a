// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/numerics/precise_vector.h"

#include <gtest/gtest.h>

#include "tests/engine/point_clouds.h"
#include "tests/engine/rational.h"

namespace raygauge::test_precise_vector {
namespace {

using Exact3 = BasicVector3<Rational>;

const Rational kLoss = Rational(0x1p-101);

Rational exact(const DoubleDouble& value) { return Rational(value.high) + Rational(value.low); }
Exact3 exact(const PreciseVector3& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }

DoubleDouble wild(Random& random) {
  std::normal_distribution<double> normal;
  const double high = std::ldexp(normal(random), static_cast<int>(random() % 7) - 3);
  return two_sum(high, 0x1p-54 * high * normal(random));
}

PreciseVector3 wild_vector(Random& random) { return {wild(random), wild(random), wild(random)}; }

Rational magnitude(const Exact3& u, const Exact3& v) {
  return abs(Rational(u.x * v.x)) + abs(Rational(u.y * v.y)) + abs(Rational(u.z * v.z));
}

// Of two vectors that are as good as orthogonal, so that nearly all of the dot product cancels.
PreciseVector3 made_orthogonal(const PreciseVector3& u, const PreciseVector3& v) {
  return v - u * (dot(u, v) / dot(u, u));
}

TEST(PreciseVector, DotProductsLoseNoMoreThanTheySay) {
  Random random(41);
  for (int trial = 0; trial < 2000; ++trial) {
    const PreciseVector3 u = wild_vector(random);
    const PreciseVector3 other = wild_vector(random);
    const PreciseVector3 v = trial % 2 == 0 ? other : made_orthogonal(u, other);
    const Exact3 exact_u = exact(u), exact_v = exact(v);
    EXPECT_LE(abs(Rational(exact(dot(u, v)) - dot(exact_u, exact_v))), kLoss * magnitude(exact_u, exact_v));
    const Vector3 w = rounded(v);
    const Exact3 exact_w = exact(precise(w));
    EXPECT_LE(abs(Rational(exact(dot(u, w)) - dot(exact_u, exact_w))), kLoss * magnitude(exact_u, exact_w));
  }
}

TEST(PreciseVector, CrossProductsLoseNoMoreThanTheySay) {
  Random random(42);
  for (int trial = 0; trial < 2000; ++trial) {
    const PreciseVector3 u = wild_vector(random);
    const PreciseVector3 other = wild_vector(random);
    const PreciseVector3 v = trial % 2 == 0 ? other : u * wild(random) + other * DoubleDouble{0x1p-70};
    const Exact3 a = exact(u), b = exact(v), error = exact(cross(u, v)) - cross(a, b);
    EXPECT_LE(abs(error.x), kLoss * (abs(Rational(a.y * b.z)) + abs(Rational(a.z * b.y))));
    EXPECT_LE(abs(error.y), kLoss * (abs(Rational(a.z * b.x)) + abs(Rational(a.x * b.z))));
    EXPECT_LE(abs(error.z), kLoss * (abs(Rational(a.x * b.y)) + abs(Rational(a.y * b.x))));
  }
}

TEST(PreciseVector, SumsOfThreeLoseNoMoreThanTheySay) {
  Random random(43);
  for (int trial = 0; trial < 2000; ++trial) {
    const PreciseVector3 a = wild_vector(random), b = wild_vector(random);
    const PreciseVector3 rest = wild_vector(random) * DoubleDouble{trial % 2 == 0 ? 1.0 : 0x1p-60};
    const PreciseVector3 c = rest - a - b;
    const Exact3 error = exact(sum_of(a, b, c)) - (exact(a) + exact(b) + exact(c));
    EXPECT_LE(abs(error.x), kLoss * (abs(exact(a.x)) + abs(exact(b.x)) + abs(exact(c.x))));
    EXPECT_LE(abs(error.y), kLoss * (abs(exact(a.y)) + abs(exact(b.y)) + abs(exact(c.y))));
    EXPECT_LE(abs(error.z), kLoss * (abs(exact(a.z)) + abs(exact(b.z)) + abs(exact(c.z))));
  }
}

}  // namespace
}  // namespace raygauge::test_precise_vector
