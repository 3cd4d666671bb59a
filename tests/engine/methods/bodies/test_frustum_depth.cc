// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/frustum_depth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/sets/direction_table.h"
#include "engine/sets/hull_3d.h"
#include "raygauge/sets/prepared_set.h"
#include "raygauge/sets/truncated_cone.h"
#include "tests/engine/random_poses.h"

namespace raygauge::test_frustum_depth {
namespace {

using testing::gaussian;
using testing::Random;
using Long = Eigen::Matrix<long double, 3, 1>;

struct Pair {
  Eigen::Vector3d base, top;
  double base_radius = 0, top_radius = 0;
  int body = 0;  // the frustum
  const PolytopeFaces* other = nullptr;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  // In the frame of the body.
  long double height(int of, const Long& u) const {
    if (of != body) {
      long double most = -1e30L;
      for (int i = 0; i < other->corners; ++i) {
        const Vector3 x = other->corner_at(i);
        most = std::max(most, u.dot(Long(x.x, x.y, x.z)));
      }
      return most;
    }
    const Long p = base.cast<long double>(), q = top.cast<long double>(), a = (q - p).normalized();
    const long double across = u.cross(a).norm();
    return std::max(u.dot(p) + across * base_radius, u.dot(q) + across * top_radius);
  }
  // Of D, for a u of any length, in the frame of the first body.
  long double height(const Long& u) const {
    return (height(0, u) + height(1, -(R.cast<long double>().transpose() * u)) -
            u.dot(t.cast<long double>())) /
           u.norm();
  }

  bool solve(FrustumDepth& depth) const {
    const TruncatedCone cone(base, base_radius, top, top_radius);
    Matrix3 turn;
    double size = base.norm() + top.norm() + base_radius + top_radius + t.norm();
    for (int j = 0; j < 3; ++j) turn.column[j] = {R(0, j), R(1, j), R(2, j)};
    for (int i = 0; i < other->corners; ++i) size = std::max(size, size + length(other->corner_at(i)));
    return depth.solve(*cone.spatial_shape(), body, *other, turn, {t[0], t[1], t[2]}, 1e-15, 2 * size, 1e-7);
  }
};

Long long_of(const Vector3& v) { return {v.x, v.y, v.z}; }

// No direction is lower than what is proven, that of the answer is as high as it says, and the points that
// it says are on both surfaces.
void expect_proven(const Pair& pair, const FrustumDepth& depth, Random& random) {
  const Long n = long_of(depth.normal());
  const auto upper = static_cast<double>(pair.height(n));
  EXPECT_GE(depth.upper(), upper);
  EXPECT_NEAR(depth.upper(), upper, 1e-11);
  EXPECT_NEAR(depth.lower(), depth.upper(), 2e-7 * depth.upper() + 1e-9);
  for (int i = 0; i < 400; ++i) {
    const double wide = i % 2 == 0 ? 1.0 : 0.01;
    const Long u = n * (i % 2) + wide * gaussian(random).cast<long double>();
    ASSERT_LE(depth.lower(), static_cast<double>(pair.height(u)));
  }
  Vector3 of_first;
  if (!depth.find_contact(of_first)) return;
  const Long one = long_of(of_first), two = pair.R.cast<long double>().transpose() *
                                            (one - n * depth.upper() - pair.t.cast<long double>());
  for (int i = 0; i < 100; ++i) {
    const Long u = i == 0 ? n : Long(gaussian(random).normalized().cast<long double>());
    const Long v = i == 0 ? Long(-(pair.R.cast<long double>().transpose() * n)) : u;
    EXPECT_LE(static_cast<double>(u.dot(one) - pair.height(0, u)), 1e-6);
    EXPECT_LE(static_cast<double>(v.dot(two) - pair.height(1, v)), 1e-6);
  }
}

Pair random_pair(Random& random, int i, const PolytopeFaces& other) {
  const double radii[4][2] = {{0.5, 0.5}, {0.6, 0.0}, {0.2, 0.7}, {0.9, 0.4}};
  Pair pair;
  pair.base = 0.3 * gaussian(random);
  pair.top = pair.base + (0.3 + std::fabs(gaussian(random)[0])) * gaussian(random).normalized();
  pair.base_radius = radii[i % 4][0];
  pair.top_radius = radii[i % 4][1];
  pair.body = i / 4 % 2;
  pair.other = &other;
  pair.R = testing::random_rotation(random).toRotationMatrix();
  pair.t = 0.3 * gaussian(random);
  return pair;
}

TEST(FrustumDepth, IsProvenOfBoxesHullsSegmentsAndPoints) {
  Random random(21);
  PolytopeFaces segment, point;
  segment.set_segment({-0.2, -0.3, 0.1}, {0.4, 0.3, 0.2});
  point.set_segment({0.1, 0.2, -0.1}, {0.1, 0.2, -0.1});
  ASSERT_EQ(point.corners, 1);
  const PolytopeFaces box = PolytopeFaces::of_box({-0.5, -1, -0.75}, {1, 0.5, 0.25});
  int solved = 0, met = 0;
  for (int i = 0; i < 800; ++i) {
    Eigen::MatrixXd points(3, 4 + i % 5);
    for (Eigen::Index k = 0; k < points.cols(); ++k) points.col(k) = 0.7 * gaussian(random);
    const PreparedSet hull(points);
    const PolytopeFaces* const of_hull = hull.spatial_shape()->table->surface().faces();
    const PolytopeFaces* const others[] = {&box, &segment, &point, of_hull != nullptr ? of_hull : &box};
    const Pair pair = random_pair(random, i / 4, *others[i % 4]);
    FrustumDepth depth;
    const bool known = pair.solve(depth);
    double least = 1;
    for (int k = 0; k < 300; ++k)
      least = std::min(least, static_cast<double>(pair.height(Long(gaussian(random).cast<long double>()))));
    EXPECT_FALSE(known && least < 0) << i;
    if (least > 0.05) ++met;
    if (!known) continue;
    ++solved;
    expect_proven(pair, depth, random);
  }
  EXPECT_GT(met, 300);
  EXPECT_GE(solved, met);
}

// Edges along the axis or across it, facets beside a disc, but for a turn: what is proven holds.
TEST(FrustumDepth, OfBodiesThatAreNearlyParallelIsNeverTooHigh) {
  Random random(22);
  const PolytopeFaces box = PolytopeFaces::of_box({-0.5, -0.4, -0.3}, {0.5, 0.4, 0.3});
  PolytopeFaces segment;
  segment.set_segment({-0.5, 0, 0}, {0.5, 0, 0});
  for (const double turn : {0.0, 1e-17, 1e-15, 1e-13, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3}) {
    for (int i = 0; i < 60; ++i) {
      Pair pair = random_pair(random, i, i % 3 == 0 ? segment : box);
      const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i / 8 % 3);
      pair.base = -0.6 * axis;
      pair.top = 0.6 * axis;
      pair.R = Eigen::AngleAxisd(turn, gaussian(random).normalized()).toRotationMatrix();
      pair.t *= i % 2;
      FrustumDepth depth;
      if (pair.solve(depth)) expect_proven(pair, depth, random);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_frustum_depth
