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

// Of a frustum the corners on its disc that are within the margin, and the highest point unless all are; a
// tilt makes them fewer. In both arithmetics.
TEST(FrustumCore, HasTheFaceThatIsWithinTheMargin) {
  SpatialShape shape = frustum();
  const Vector3 way = shape.top - shape.base;
  shape.axis.column[0] = way * (1 / length(way));
  const FrustumCore core{shape};
  const Vector3 side = any_orthogonal(shape.axis.column[0]);
  for (const double tilt : {0.0, 1e-3, 0.1, 0.5}) {
    const Vector3 v = -shape.axis.column[0] + side * tilt;
    const double margin = 0.01, top = core.look(v, InstructionSet::automatic).height(FrustumCore::kBase);
    int count = 0, precise_count = 0;
    bool has_highest = false;
    core.face(v, margin, InstructionSet::automatic, [&](const Vector3& x) {
      ++count;
      EXPECT_GE(dot(v, x), top - margin - 1e-15);
      EXPECT_NEAR(length(x - shape.base), shape.base_radius, 1e-14);
      has_highest = has_highest || dot(v, x) >= top - 1e-15;
    });
    core.face(precise(v), margin, InstructionSet::automatic, [&](const PreciseVector3&) { ++precise_count; });
    EXPECT_EQ(count, precise_count) << tilt;
    EXPECT_TRUE(has_highest) << tilt;
    EXPECT_EQ(count == FrustumCore::kFaceCorners, tilt < 0.005) << tilt;
  }
}

TEST(BoxCore, HasTheFaceThatIsWithinTheMargin) {
  SpatialShape shape;
  shape.kind = SpatialShape::Kind::box;
  shape.base = {-1, -2, -3};
  shape.top = {1, 2, 3};
  const auto count = [&](const Vector3& v) {
    int points = 0;
    with_core(shape, [&](const auto& core) {
      core.face(v, 0.01, InstructionSet::automatic, [&](const Vector3& x) {
        ++points;
        EXPECT_GE(dot(v, x), dot(v, shape.top) - 0.01);
      });
    });
    return points;
  };
  EXPECT_EQ(count({0, 0, 1}), 4);
  EXPECT_EQ(count({0.001, 0.001, 1}), 4);
  EXPECT_EQ(count({0.1, 0.001, 1}), 2);
  EXPECT_EQ(count({0.1, 0.1, 1}), 1);
  EXPECT_FALSE(has_one_top(shape, {0, 0, 1}, 1e-7, InstructionSet::automatic));
  EXPECT_FALSE(has_one_top(shape, {0.6, 0, 0.8}, 1e-7, InstructionSet::automatic));
  EXPECT_TRUE(has_one_top(shape, {0.48, 0.36, 0.8}, 1e-7, InstructionSet::automatic));
}

}  // namespace
}  // namespace raygauge::test_cores
