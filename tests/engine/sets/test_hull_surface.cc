// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/hull_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "engine/sets/hull_3d.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge::test_hull_surface {
namespace {

using V = Eigen::Vector3d;
using Random = std::mt19937_64;

constexpr auto kIsa = InstructionSet::automatic;
constexpr double kNoise = 1e-13;  // of a hull of size 4

V gaussian(Random& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

Eigen::Matrix3Xd cube() {
  Eigen::Matrix3Xd points(3, 8);
  for (int i = 0; i < 8; ++i)
    points.col(i) = V((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 2 : -2, (i & 4) != 0 ? 3 : -3);
  return points;
}

const std::vector<int> kCube = {0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5, 0, 1, 4, 1, 5, 4,
                                2, 6, 3, 3, 6, 7, 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6};

TEST(HullSurface, OfABoxKnowsTheNearestSide) {
  const HullSurface surface(cube(), kCube, cube().colwise().norm().maxCoeff());
  ASSERT_FALSE(surface.empty());
  const HullSurface::Nearest side = surface.nearest({-0.25, 1.5, 0.5}, kIsa);
  EXPECT_NEAR(side.room, 0.5, kNoise);
  EXPECT_LE(side.room, 0.5);
  EXPECT_EQ(side.normal.y, 1);
  EXPECT_NEAR(surface.nearest({0, 0, 0}, kIsa).room, 1, kNoise);
  int near = 0;
  const auto count = [&](const Vector3& n) { near += std::fabs(n.x) == 1 ? 1 : 0; };
  surface.for_near({0, 0, 0}, 1 + 1e-9, kIsa, count);
  EXPECT_EQ(near, 4);  // two triangles on either side
  surface.for_near_of_sum({0, 0, 0}, {}, 1 + 1e-9, count);
  EXPECT_EQ(near, 8);
}

// Half sizes 1, 2, 3; the segment adds its own, and cuts no way short. Along an edge of two sides' it has
// none.
TEST(HullSurface, WithASegmentIsLargerByIt) {
  const HullSurface surface(cube(), kCube, cube().colwise().norm().maxCoeff());
  const HullSurface::Nearest side = surface.nearest_of_sum({0, 0, 0}, {0.5, 0.25, 0.125});
  EXPECT_NEAR(side.room, 1.5, kNoise);
  EXPECT_EQ(std::fabs(side.normal.x), 1);
  EXPECT_FALSE(side.is_edge);
  EXPECT_NEAR(side.second, 1.5, kNoise);  // on the other side
  EXPECT_NEAR(surface.nearest_of_sum({0.5, 0, 0}, {0.125, 0.125, 0.125}).second, 0.625, kNoise);
  // Out of an edge along z: across it and the segment, (3, -4, 0)/5 from (1, -2).
  const HullSurface::Nearest edge = surface.nearest_of_sum({0.5, -1.5, 0}, {4, 3, 0.01});
  EXPECT_TRUE(edge.is_edge);
  EXPECT_NEAR(edge.room, 0.5 * 0.6 + 0.5 * 0.8, 1e-4);
  EXPECT_EQ(surface.nearest_of_sum({0, 0, 0}, {0, 9, 0}).room, 0);  // parallel to the nearest side
  EXPECT_EQ(surface.nearest_of_sum({2.1, 0, 0}, {1, 0.1, 0.1}).room, 0);
}

TEST(HullSurface, HasNoRoomOutside) {
  const HullSurface surface(cube(), kCube, cube().colwise().norm().maxCoeff());
  for (const Vector3& y :
       {Vector3{1.1, 0, 0}, Vector3{1, 0, 0}, Vector3{1 - 1e-15, 0, 0}, Vector3{0, 0, -100}})
    EXPECT_EQ(surface.nearest(y, kIsa).room, 0) << y.x << " " << y.z;
}

// Whatever the triangles are: what is no closed surface proves nothing.
TEST(HullSurface, IsEmptyWhereTheTrianglesAreNotClosed) {
  std::vector<int> open = kCube, twisted = kCube;
  open.resize(33);
  std::swap(twisted[0], twisted[1]);
  for (const std::vector<int>& triangles : {open, twisted, std::vector<int>{}})
    EXPECT_TRUE(HullSurface(cube(), triangles, 4).empty());
}

// From inside out it winds the other way: no point is seen to be inside.
TEST(HullSurface, TurnedInsideOutProvesNothing) {
  std::vector<int> inside_out = kCube;
  for (std::size_t i = 0; i < inside_out.size(); i += 3) std::swap(inside_out[i], inside_out[i + 1]);
  EXPECT_EQ(HullSurface(cube(), inside_out, 4).nearest({0, 0, 0}, kIsa).room, 0);
}

// The depth of a ball or a capsule in a hull, by its surface, is that of the search, which a set that is not
// prepared has.
TEST(HullSurface, ProvesTheDepthThatTheSearchFinds) {
  if (!has_hull_3d()) return;
  Random random(5);
  const Ball metric(V::Zero(), 2);
  int by_surface = 0;
  for (int trial = 0; trial < 1500; ++trial) {
    Eigen::Matrix3Xd points(3, trial % 3 == 0 ? 5 + trial % 8 : trial % 3 == 1 ? 40 : 300);
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      points.col(i) = gaussian(random).normalized() + V(0.1, 0, 0.2);
    if (trial % 5 == 0) points.row(trial % 2) *= 1e-3;
    const PreparedSet prepared(points);
    const PointSet plain(points);
    const V middle = 0.2 * gaussian(random), half = trial % 7 < 4 ? V(0.4 * gaussian(random)) : V(0, 0, 0);
    const Capsule body(middle - half, middle + half, trial % 4 == 0 ? 0.0 : 0.3);
    const Pose pose(Eigen::Quaterniond(Eigen::Vector4d::Random().normalized()), 0.3 * gaussian(random));
    const Pose moved(Eigen::Quaterniond(Eigen::Vector4d::Random().normalized()), pose.apply(V(0.1, 0, 0.2)));
    const bool swapped = trial % 2 == 0;
    const auto depth_of = [&](const ConvexSet& hull) {
      ObjectDistanceSolver solver;
      const Posed one(hull, pose), two(body, moved);
      return solver.solve(swapped ? two : one, swapped ? one : two, metric, ObjectEffects::depth);
    };
    const ObjectDistance quick = depth_of(prepared), searched = depth_of(plain);
    ASSERT_EQ(quick.distance.status, searched.distance.status) << trial;
    if (!(searched.depth.lower > 1e-9)) continue;
    EXPECT_EQ(quick.depth.status, DistanceStatus::optimal) << trial;
    EXPECT_LE(quick.depth.lower, searched.depth.upper) << trial;
    EXPECT_GE(quick.depth.upper, searched.depth.lower) << trial;
    const V way = quick.depth.point_2 - quick.depth.point_1;
    EXPECT_LE((way - 4 * quick.depth.depth * quick.depth.normal).norm(), 1e-5 * 2 * quick.depth.depth)
        << trial;
    if (quick.depth.iterations == 1) ++by_surface;
  }
  EXPECT_GT(by_surface, 500);
}

// The centre of a cube: three sides, and their opposites, are as near.
TEST(HullSurface, NamesAllWaysOutThatAreAsShort) {
  if (!has_hull_3d()) return;
  Eigen::Matrix3Xd points = cube();
  points.row(1) /= 2;
  points.row(2) /= 3;
  const PreparedSet hull(points);
  const Ball ball(V::Zero(), 0.5), metric(V::Zero(), 1);
  ObjectDistanceSolver solver;
  const ObjectDistance& r =
      solver.solve(hull, ball, metric, ObjectEffects::depth | ObjectEffects::pose_gradient);
  EXPECT_NEAR(r.depth.depth, 1.5, 1e-6);
  ASSERT_EQ(r.pose_gradient.kind, GradientKind::one_sided);
  for (const Vector3& way : {Vector3{1, 0, 0}, Vector3{0, -1, 0}, Vector3{0, 0, 1}})
    EXPECT_NEAR(r.pose_gradient.along({}, {way, {}}), 1, 1e-9);
}

}  // namespace
}  // namespace raygauge::test_hull_surface
