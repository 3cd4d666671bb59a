// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/facet_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/methods/bodies/facet_rounding.h"
#include "engine/methods/spatial/triangle_normal.h"
#include "engine/numerics/real.h"

namespace raygauge::test_facet_lanes {
namespace {

using Random = std::mt19937_64;

Vector3 gaussian(Random& random, double size) {
  std::normal_distribution<double> normal(0, size);
  return {normal(random), normal(random), normal(random)};
}

// The plane of lane l in double-double arithmetic: the least n·s over the corners, for the n that it has.
DoubleDouble exact_least(const FacetLanes& lanes, int l) {
  const Vector3 n{lanes.n[0][l], lanes.n[1][l], lanes.n[2][l]};
  DoubleDouble least{1e300};
  for (const auto& corner : lanes.corner) {
    const DoubleDouble height = dot(precise(n), Vector3{corner[0][l], corner[1][l], corner[2][l]});
    if (height < least) least = height;
  }
  return least;
}

// How far n is off the true normal, of length one.
double turned(const FacetLanes& lanes, int l) {
  PreciseVector3 s[3];
  for (int c = 0; c < 3; ++c)
    s[c] = precise({lanes.corner[c][0][l], lanes.corner[c][1][l], lanes.corner[c][2][l]});
  const PreciseVector3 n = triangle_normal<DoubleDouble>(s[0], s[1], s[2]);
  const PreciseVector3 of_n = n * (DoubleDouble{1} / sqrt(dot(n, n)));
  return length(rounded(of_n - precise({lanes.n[0][l], lanes.n[1][l], lanes.n[2][l]})));
}

double size_of(const FacetLanes& lanes) {
  double size = 0;
  for (const auto& corner : lanes.corner)
    for (int l = 0; l < FacetLanes::kCount; ++l)
      size = std::max(size, std::hypot(corner[0][l], corner[1][l], corner[2][l]));
  return size * (1 + 1e-15);
}

FacetLanes random_lanes(Random& random, double flat) {
  FacetLanes lanes;
  for (int l = 0; l < FacetLanes::kCount; ++l) {
    const Vector3 center = gaussian(random, 1), way = gaussian(random, 1);
    for (auto& corner : lanes.corner) {
      const double along = gaussian(random, 1).x;
      const Vector3 s = center + way * along + gaussian(random, flat);
      corner[0][l] = s.x;
      corner[1][l] = s.y;
      corner[2][l] = s.z;
    }
  }
  return lanes;
}

TEST(FacetLanes, HaveUnitNormalsAndOffsetsThatAreProven) {
  Random random(9);
  int proven = 0, refused = 0;
  for (const double flat : {1.0, 1e-3, 1e-8, 1e-13, 1e-15}) {
    for (int i = 0; i < 500; ++i) {
      FacetLanes lanes = random_lanes(random, flat);
      measure_facets(size_of(lanes), lanes);
      for (int l = 0; l < FacetLanes::kCount; ++l) {
        const Vector3 n{lanes.n[0][l], lanes.n[1][l], lanes.n[2][l]};
        if (!(lanes.offset[l] > 0)) {
          ++refused;
          continue;
        }
        ++proven;
        EXPECT_NEAR(length(n), 1, 0x1p-50);
        EXPECT_LE(lanes.offset[l], exact_least(lanes, l).rounded());
        EXPECT_LE(turned(lanes, l) * size_of(lanes), lanes.offset[l]);  // so it is seen from the right side
        EXPECT_NEAR(lanes.reach[l], exact_least(lanes, l).rounded(), 2 * turned(lanes, l) * 10 + 1e-14);
      }
    }
  }
  EXPECT_GT(proven, 5000);
  EXPECT_GT(refused, 5000);
}

// Two corners at one place, three, on a line, and nothing at all.
TEST(FacetLanes, ProveNothingOfATriangleWithoutArea) {
  FacetLanes lanes;
  const double x[FacetLanes::kCount][3] = {{1, 1, 1}, {1, 1, 2}, {1, 2, 3}, {0, 0, 0},
                                           {1, 2, 1}, {2, 1, 1}, {5, 1, 3}, {1e-200, 2e-200, 1e-200}};
  for (int l = 0; l < FacetLanes::kCount; ++l)
    for (int c = 0; c < 3; ++c)
      for (int k = 0; k < 3; ++k) lanes.corner[c][k][l] = x[l][c] * (k == 0 && l == 7 ? 1.5 : 1.0);
  measure_facets(10, lanes);
  for (int l = 0; l < FacetLanes::kCount; ++l) EXPECT_LE(lanes.offset[l], 0) << l;
}

}  // namespace
}  // namespace raygauge::test_facet_lanes
