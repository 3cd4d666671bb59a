// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The origin inside a tetrahedron, against rational arithmetic.
#include "engine/methods/spatial/nearest_on_simplex.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/engine/rational.h"

namespace raygauge::test_nearest_on_simplex {
namespace {

using Corners = std::array<Vector3, 4>;
using RationalVector = BasicVector3<Rational>;

RationalVector exact(const Vector3& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

/// Whether the ball of this radius about the origin lies in the tetrahedron.
bool holds_ball(const Corners& corner, double radius) {
  constexpr int kFacets[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  for (int f = 0; f < 4; ++f) {
    const RationalVector a = exact(corner[static_cast<std::size_t>(kFacets[f][0])]);
    const RationalVector n = cross(exact(corner[static_cast<std::size_t>(kFacets[f][1])]) - a,
                                   exact(corner[static_cast<std::size_t>(kFacets[f][2])]) - a);
    const Rational opposite = dot(n, exact(corner[static_cast<std::size_t>(f)]) - a), origin = -dot(n, a);
    if (opposite * origin <= 0) return false;
    if (origin * origin < Rational(radius) * Rational(radius) * dot(n, n)) return false;
  }
  return true;
}

/// Four points in random directions, so flat that rounding tilts their facets, shifted so that the origin is
/// about on one of them.
Corners flat_corners(std::mt19937_64& random, double flatness) {
  std::normal_distribution<double> normal;
  const Vector3 along{normal(random), normal(random), normal(random)};
  const Vector3 across = any_orthogonal(along), up = cross(along, across) * (1 / length(along));
  Corners corner;
  for (Vector3& point : corner)
    point = along * normal(random) + across * (flatness * normal(random)) + up * (flatness * normal(random));
  std::uniform_real_distribution<double> share;
  const double a = share(random), b = (1 - a) * share(random);
  const double inside = 1e-16 * std::exp(4 * normal(random));
  const Vector3 origin =
      corner[0] * (a - inside) + corner[1] * b + corner[2] * (1 - a - b) + corner[3] * inside;
  for (Vector3& point : corner) point = point - origin;
  return corner;
}

TEST(NearestOnSimplex, TheBallInsideFourPointsIsProven) {
  std::mt19937_64 random(17);
  int found = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Corners corner = flat_corners(random, std::pow(10.0, -0.5 * (trial % 16)));
    const Vector3* points[4] = {corner.data(), &corner[1], &corner[2], &corner[3]};
    const SimplexFace<double> face = nearest_face(points, 4);
    if (face.count < 4) continue;
    ++found;
    ASSERT_TRUE(holds_ball(corner, face.depth)) << "trial " << trial << ", depth " << face.depth;
  }
  EXPECT_GT(found, 500);
}

TEST(NearestOnSimplex, TheDepthInARegularTetrahedronIsThatOfItsFacets) {
  const Corners corner = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  const Vector3* points[4] = {corner.data(), &corner[1], &corner[2], &corner[3]};
  const SimplexFace<double> face = nearest_face(points, 4);
  ASSERT_EQ(face.count, 4);
  EXPECT_LE(face.depth, 1 / std::sqrt(3.0));
  EXPECT_NEAR(face.depth, 1 / std::sqrt(3.0), 1e-14);
  for (const double weight : face.weight) EXPECT_NEAR(weight, 0.25, 1e-15);
}

}  // namespace
}  // namespace raygauge::test_nearest_on_simplex
