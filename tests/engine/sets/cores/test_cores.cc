// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/cores/core.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/engine/rational.h"

namespace raygauge::test_cores {
namespace {

using Random = std::mt19937_64;
using Exact3 = BasicVector3<Rational>;

constexpr double kLoss = 0x1p-94;  // of heights and points of size 1

Rational exact(const DoubleDouble& value) { return Rational(value.high) + Rational(value.low); }
Exact3 exact(const PreciseVector3& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }

PreciseVector3 random_direction(Random& random) {
  std::normal_distribution<double> normal;
  const auto one = [&] { return two_sum(normal(random), 0x1p-54 * normal(random)); };
  return {one(), one(), one()};
}

SpatialShape frustum() {
  SpatialShape shape;
  shape.kind = SpatialShape::Kind::frustum;
  shape.base = {0.25, -0.125, -0.5};
  shape.top = {0.5, 0.375, 0.75};
  shape.base_radius = 0.75;
  shape.top_radius = 0.25;
  return shape;
}

// A point c + r of a rim: r is across the axis and as long as the radius, and no point of it is higher, as
// v·r = |v_⊥| radius.
TEST(FrustumCore, RimsHaveTheirHighestPoint) {
  Random random(61);
  const SpatialShape shape = frustum();
  const Exact3 axis = exact(precise(shape.top) - precise(shape.base));
  for (int trial = 0; trial < 500; ++trial) {
    PreciseVector3 v = random_direction(random);
    if (trial % 3 == 0) v = v * DoubleDouble{1e-9} + precise(shape.top - shape.base);
    const FrustumCore core{shape};
    const auto view = core.look(v, InstructionSet::automatic);
    const std::int32_t index = view.index;
    const bool top = index == FrustumCore::kTop;
    const Rational radius(top ? shape.top_radius : shape.base_radius);
    const Exact3 x = exact(view.point(index)), r = x - exact(precise(top ? shape.top : shape.base));
    // Near the axis v_⊥ is known to a share of |v|.
    const double loss = kLoss * (trial % 3 == 0 ? 1e9 : 1.0);
    EXPECT_LE(abs(Rational(dot(r, axis))), Rational(loss));
    EXPECT_LE(abs(Rational(dot(r, r) - radius * radius)), Rational(kLoss));
    EXPECT_LE(abs(Rational(exact(view.height(index)) - dot(exact(v), x))), Rational(16 * kLoss));
    const auto other = top ? FrustumCore::kBase : FrustumCore::kTop;
    EXPECT_GE(exact(view.height(index)), exact(view.height(other)));
  }
}

// The point c + z is on the surface, |L⁻¹z| = 1, and as high as the height says.
TEST(EllipsoidCore, HasItsHighestPoint) {
  Random random(62);
  SpatialShape shape;
  shape.kind = SpatialShape::Kind::ellipsoid;
  shape.center = {0.5, -0.25, 1};
  shape.axis = {{{1, 0.25, 0}, {0, 0.5, 0.125}, {0.0625, 0, 0.375}}};
  const Vector3* L = shape.axis.column;
  const Exact3 column[3] = {exact(precise(L[0])), exact(precise(L[1])), exact(precise(L[2]))};
  const Rational determinant = dot(column[0], cross(column[1], column[2]));
  for (int trial = 0; trial < 500; ++trial) {
    const PreciseVector3 v = random_direction(random);
    const EllipsoidCore core{shape};
    const auto view = core.look(v, InstructionSet::automatic);
    const PreciseVector3 x = view.point(view.index);
    EXPECT_LE(abs(Rational(exact(view.height(view.index)) - dot(exact(v), exact(x)))), Rational(16 * kLoss));
    const Exact3 z = exact(x) - exact(precise(shape.center));
    Rational square = 0;
    for (int k = 0; k < 3; ++k) {
      const Rational y = dot(z, cross(column[(k + 1) % 3], column[(k + 2) % 3])) / determinant;
      square += y * y;
    }
    EXPECT_LE(abs(Rational(square - 1)), Rational(16 * kLoss));
  }
}

}  // namespace
}  // namespace raygauge::test_cores
