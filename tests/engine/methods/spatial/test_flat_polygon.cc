// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/flat_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace raygauge::test_flat_polygon {
namespace {

constexpr double kRounding = 1e-12;

FlatPolygon random_polygon(std::mt19937_64& random, int count) {
  std::normal_distribution<double> normal;
  FlatPolygon polygon;
  for (int i = 0; i < count; ++i) polygon.add({normal(random), normal(random), i});
  polygon.make_hull(kRounding);
  return polygon;
}

double area(const FlatPolygon& polygon) {
  double sum = 0;
  const auto& c = polygon.corners();
  for (std::size_t i = 0; i < c.size(); ++i) {
    const FlatPoint& next = c[(i + 1) % c.size()];
    sum += 0.5 * (c[i].x * next.y - c[i].y * next.x);
  }
  return sum;
}

TEST(FlatPolygon, HullHoldsAllPointsAndTurnsLeft) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    FlatPolygon points, hull;
    for (int i = 0; i < 3 + trial % 20; ++i) points.add({normal(random), normal(random), i});
    hull = points;
    hull.make_hull(kRounding);
    ASSERT_GE(hull.count(), 3);
    EXPECT_GT(area(hull), 0);
    for (const FlatPoint& p : points.corners()) EXPECT_GE(hull.depth_of(p), -1e-9);
    for (const FlatPoint& p : hull.corners()) EXPECT_LE(std::fabs(hull.depth_of(p)), 1e-9);
  }
}

TEST(FlatPolygon, HullOfFewOrCollinearPointsIsASegmentOrAPoint) {
  FlatPolygon line, point;
  for (const double t : {0.5, 0.0, 1.0, 0.25}) line.add({t, 2 * t, 0});
  line.make_hull(kRounding);
  EXPECT_EQ(line.count(), 2);
  for (int i = 0; i < 3; ++i) point.add({1, 1 + 1e-14 * i, i});
  point.make_hull(kRounding);
  EXPECT_EQ(point.count(), 1);
}

// The common part is the same whichever is cut by the other, and in both.
TEST(FlatPolygon, CutsEachOtherToTheSamePart) {
  std::mt19937_64 random(2);
  int met = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const FlatPolygon one = random_polygon(random, 5 + trial % 7), two = random_polygon(random, 6);
    FlatPolygon common = one, other = two;
    common.cut(two, 0, 0);
    other.cut(one, 0, 0);
    EXPECT_NEAR(area(common), area(other), 1e-9);
    EXPECT_LE(area(common), std::min(area(one), area(two)) + 1e-12);
    for (const FlatPoint& p : common.corners()) EXPECT_GE(std::min(one.depth_of(p), two.depth_of(p)), -1e-9);
    met += common.is_empty() ? 0 : 1;
  }
  EXPECT_GT(met, 100);
}

TEST(FlatPolygon, CutsSegmentsAndPoints) {
  FlatPolygon square, segment, point;
  for (const auto& [x, y] : {std::pair(0.0, 0.0), {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}) square.add({x, y, 0});
  segment.add({-1, 1, 0});
  segment.add({1, 1, 1});
  point.add({3, 1, 0});
  FlatPolygon part = segment;
  part.cut(square, 0, 0);
  ASSERT_EQ(part.count(), 2);
  EXPECT_NEAR(part.corners()[0].x, 0, kRounding);
  EXPECT_NEAR(part.corners()[1].x, 1, kRounding);
  FlatPolygon outside = point;
  outside.cut(square, 0.5, 0.5);
  EXPECT_TRUE(outside.is_empty());
  point.cut(square, 1.5, 1.5);
  EXPECT_EQ(point.count(), 1);
}

}  // namespace
}  // namespace raygauge::test_flat_polygon
