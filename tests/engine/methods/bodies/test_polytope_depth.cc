// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/polytope_depth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "engine/sets/direction_table.h"
#include "engine/sets/hull_3d.h"
#include "engine/sets/spatial_shape.h"
#include "raygauge/sets/prepared_set.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_polytope_depth {
namespace {

using testing::gaussian;
using testing::Random;
using Long = Eigen::Matrix<long double, 3, 1>;
using Points = std::vector<Long>;

struct Place {
  Eigen::Matrix3d R;
  Eigen::Vector3d t;

  Matrix3 rotation() const {
    Matrix3 out;
    for (int j = 0; j < 3; ++j) out.column[j] = {R(0, j), R(1, j), R(2, j)};
    return out;
  }
  Vector3 way() const { return {t[0], t[1], t[2]}; }
};

Points corners_of(const PolytopeFaces& faces, const Place* at) {
  Points corners;
  for (int i = 0; i < faces.corners; ++i) {
    const Vector3 x = faces.corner_at(i);
    const Long corner(x.x, x.y, x.z);
    corners.push_back(at == nullptr ? corner
                                    : Long(at->R.cast<long double>() * corner + at->t.cast<long double>()));
  }
  return corners;
}

// Of P1 - P2: along the normals of all triangles of corners, and across all pairs of ways between corners. In
// each direction the height is at least the depth, and the nearest facet is across one of them.
long double depth_of(const Points& one, const Points& two) {
  long double least = std::numeric_limits<long double>::infinity();
  const auto look = [&](Long n) {
    const long double size = n.norm();
    if (!(size > 1e-9L)) return;
    n /= size;
    long double up[2] = {-1e30L, -1e30L}, down[2] = {1e30L, 1e30L};
    for (int i = 0; i < 2; ++i) {
      for (const Long& x : i == 0 ? one : two) {
        up[i] = std::max(up[i], n.dot(x));
        down[i] = std::min(down[i], n.dot(x));
      }
    }
    least = std::min({least, up[0] - down[1], up[1] - down[0]});
  };
  const auto ways = [](const Points& points) {
    Points all;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) all.push_back(points[i] - points[k]);
    return all;
  };
  const Points of_one = ways(one), of_two = ways(two);
  for (const Long& a : of_one)
    for (const Long& b : of_two) look(a.cross(b));
  for (const Points* own : {&of_one, &of_two})
    for (const Long& a : *own)
      for (const Long& b : *own) look(a.cross(b));
  return least;
}

bool solve(const PolytopeFaces& one, const PolytopeFaces& two, const Place& at, PolytopeDepth& depth) {
  const auto extent = [](const PolytopeFaces& faces) {
    double most = 0;
    for (int i = 0; i < faces.corners; ++i) most = std::max(most, length(faces.corner_at(i)));
    return most;
  };
  return depth.solve(one, two, at.rotation(), at.way(), 1e-15, 2 * (extent(one) + extent(two) + at.t.norm()));
}

Place random_place(Random& random, double way) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(gaussian(random).norm(), gaussian(random).normalized()))
              .toRotationMatrix(),
          way * gaussian(random)};
}

PreparedSet random_hull(Random& random, int count) {
  Eigen::MatrixXd points(3, count);
  for (int i = 0; i < count; ++i) points.col(i) = gaussian(random);
  return PreparedSet(points);
}

const PolytopeFaces* faces_of(const PreparedSet& set) {
  return set.spatial_shape()->table->surface().faces();
}

// That point of P1, and the one of P2 that is as far in as the depth, are on both surfaces.
void expect_contact(const PolytopeFaces& one, const PolytopeFaces& two, const Place& at,
                    const PolytopeDepth& depth) {
  Vector3 of_first;
  if (!depth.find_contact(of_first)) return;
  const Points first = corners_of(one, nullptr), second = corners_of(two, &at);
  const Vector3 &n = depth.normal(), of_second = of_first - n * depth.upper();
  const Long u(n.x, n.y, n.z);
  long double most = -1e30L, least = 1e30L;
  for (const Long& x : first) most = std::max(most, u.dot(x));
  for (const Long& x : second) least = std::min(least, u.dot(x));
  EXPECT_NEAR(dot(n, of_first), static_cast<double>(most), 1e-9);
  EXPECT_NEAR(dot(n, of_second), static_cast<double>(least), 1e-9);
  for (int i = 0; i < one.facets; ++i) {
    long double top = -1e30L;
    const Vector3 m = one.normal_at(i);
    for (const Long& x : first) top = std::max(top, Long(m.x, m.y, m.z).dot(x));
    EXPECT_LE(dot(m, of_first), static_cast<double>(top) + 1e-9);
  }
}

TEST(PolytopeDepth, EdgesOfFacesGoAlongTheProductOfTheNormalsBesideThem) {
  Random random(13);
  const auto expect_along = [](const PolytopeFaces& faces) {
    for (int i = 0; i < faces.edges; ++i) {
      const Vector3 across = cross(faces.normal_at(faces.left[i]), faces.normal_at(faces.right[i]));
      EXPECT_GT(dot(across, faces.way_at(i)), 0) << i;
    }
  };
  expect_along(PolytopeFaces::of_box({-0.5, -1, -0.75}, {1, 0.5, 0.25}));
  for (int i = 0; i < 20 && has_hull_3d(); ++i) {
    const PreparedSet hull = random_hull(random, 4 + i % 6);
    if (faces_of(hull) != nullptr) expect_along(*faces_of(hull));
  }
}

TEST(PolytopeDepth, IsThatOfTheNearestFacet) {
  if (!has_hull_3d()) return;
  Random random(11);
  int solved = 0, asked = 0;
  for (int i = 0; i < 600; ++i) {
    const PreparedSet hull_1 = random_hull(random, 5 + i % 6), hull_2 = random_hull(random, 5 + i / 6 % 6);
    const PolytopeFaces box = PolytopeFaces::of_box({-0.5, -1, -0.75}, {1, 0.5, 0.25});
    const PolytopeFaces *one = i % 3 == 1 ? &box : faces_of(hull_1),
                        *two = i % 3 == 2 ? &box : faces_of(hull_2);
    if (one == nullptr || two == nullptr) continue;
    const Place at = random_place(random, 0.3);
    const auto truth = static_cast<double>(depth_of(corners_of(*one, nullptr), corners_of(*two, &at)));
    PolytopeDepth depth;
    const bool known = solve(*one, *two, at, depth);
    EXPECT_FALSE(known && truth < 0) << i;
    if (truth > 1e-6) ++asked;
    if (!known) continue;
    ++solved;
    EXPECT_LE(depth.lower(), truth) << i;
    EXPECT_GE(depth.upper(), truth * (1 - 1e-15)) << i;
    EXPECT_LE(depth.upper() - depth.lower(), 1e-9) << i;
    expect_contact(*one, *two, at, depth);
  }
  EXPECT_GT(solved, 500);
  EXPECT_GE(solved, asked - 3);
}

// Edges that are parallel, but for a turn: a bound that is proven holds whatever rounding has hidden.
TEST(PolytopeDepth, OfNearlyParallelEdgesIsNeverTooHigh) {
  Random random(12);
  const PolytopeFaces one = PolytopeFaces::of_box({-1, -1, -1}, {1, 1, 1}),
                      two = PolytopeFaces::of_box({-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3});
  for (const double turn : {0.0, 1e-17, 1e-15, 1e-13, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3}) {
    for (int i = 0; i < 50; ++i) {
      const Place at{Eigen::AngleAxisd(turn, gaussian(random).normalized()).toRotationMatrix(),
                     0.5 * gaussian(random)};
      PolytopeDepth depth;
      if (!solve(one, two, at, depth)) continue;
      const auto truth = static_cast<double>(depth_of(corners_of(one, nullptr), corners_of(two, &at)));
      EXPECT_LE(depth.lower(), truth) << turn;
      EXPECT_GE(depth.upper(), truth * (1 - 1e-15)) << turn;
    }
  }
}

TEST(PolytopeDepth, HasNoFacesOfHullsWithMoreThanThreeCornersInAPlane) {
  if (!has_hull_3d()) return;
  Eigen::MatrixXd cube(3, 8);
  for (int i = 0; i < 8; ++i) cube.col(i) = Eigen::Vector3d(i & 1, i >> 1 & 1, i >> 2 & 1);
  EXPECT_EQ(faces_of(PreparedSet(cube)), nullptr);
}

}  // namespace
}  // namespace raygauge::test_polytope_depth
