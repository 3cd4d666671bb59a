// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/zonotope_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "engine/numerics/precise_vector.h"

namespace raygauge::test_zonotope_depth {
namespace {

using Random = std::mt19937_64;

Vector3 gaussian(Random& random, double size) {
  std::normal_distribution<double> normal(0, size);
  return {normal(random), normal(random), normal(random)};
}

struct Zonotope {
  Vector3 center;
  std::vector<Vector3> half;

  double size() const {
    double sum = length(center);
    for (const Vector3& g : half) sum += length(g);
    return sum * (1 + 1e-14);
  }

  DoubleDouble height(const PreciseVector3& n) const {
    const auto absolute = [](const DoubleDouble& x) { return x.high < 0 ? -x : x; };
    DoubleDouble sum = -absolute(dot(n, center));
    for (const Vector3& g : half) sum = sum + absolute(dot(n, g));
    return sum / sqrt(dot(n, n));
  }

  // Of all facets, in double-double arithmetic.
  double depth() const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < half.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const PreciseVector3 n = cross(precise(half[i]), precise(half[j]));
        if (length(rounded(n)) > 0) least = std::min(least, height(n).rounded());
      }
    return least;
  }
};

bool solve(const Zonotope& of, ZonotopeDepth& depth) {
  depth.begin(of.center);
  for (const Vector3& g : of.half) depth.add_first(g);
  return depth.solve(of.size());
}

// `near`: some generators are turned from another one by about that.
Zonotope random_zonotope(Random& random, double near) {
  Zonotope made;
  made.center = gaussian(random, 0.3);
  const int count = 3 + static_cast<int>(random() % 4);
  for (int k = 0; k < count; ++k) {
    const Vector3 other =
        k >= 3 ? made.half[random() % 3] * (0.5 + static_cast<double>(random() % 3)) : Vector3{};
    made.half.push_back(k >= 3 && near < 1 ? other + gaussian(random, near) : gaussian(random, 1));
  }
  return made;
}

TEST(ZonotopeDepth, IsThatOfTheNearestFacet) {
  Random random(11);
  int proven = 0, contacts = 0;
  for (const double near : {1.0, 1e-3, 1e-6, 1e-8, 1e-10, 1e-13, 0.0}) {
    for (int i = 0; i < 2000; ++i) {
      const Zonotope body = random_zonotope(random, near);
      ZonotopeDepth depth;
      if (!solve(body, depth)) continue;
      ++proven;
      const double truth = body.depth(), size = body.size();
      ASSERT_LE(depth.lower(), truth) << near;
      ASSERT_GE(depth.upper(), truth) << near;
      ASSERT_LE(depth.upper() - depth.lower(), 1e-6 * size) << near;
      ASSERT_NEAR(length(depth.normal()), 1, 1e-15);
      ASSERT_NEAR(body.height(precise(depth.normal())).rounded(), truth, 1e-6 * size);
      Vector3 sum;
      if (!depth.find_contact(sum)) continue;
      ++contacts;
      ASSERT_NEAR(length(body.center + sum - depth.normal() * depth.upper()), 0, 1e-12 * size);
    }
  }
  EXPECT_GT(proven, 8000);
  EXPECT_GT(contacts, proven / 2);
}

TEST(ZonotopeDepth, ProvesNothingOutsideOrOfAFlatBody) {
  ZonotopeDepth depth;
  EXPECT_FALSE(solve({{3, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, depth));
  EXPECT_FALSE(solve({{}, {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}}, depth));
  EXPECT_FALSE(solve({{}, {{1, 0, 0}, {2, 0, 0}}}, depth));
  EXPECT_FALSE(solve({{}, {{1, 0, 0}, {0, 1, 0}, {}}}, depth));
  ASSERT_TRUE(solve({{}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}}, depth));
  EXPECT_NEAR(depth.upper(), 1, 1e-13);
}

}  // namespace
}  // namespace raygauge::test_zonotope_depth
