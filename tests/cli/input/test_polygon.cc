// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/polygon.h"

#include <gtest/gtest.h>

#include <cmath>

namespace raygauge::cli::test_polygon {
namespace {

double signed_area(const std::vector<Vertex>& v, const Triangle& t) {
  const auto at = [&](std::size_t i) { return v[static_cast<std::size_t>(t[i])]; };
  const Vertex a = at(0), b = at(1), c = at(2);
  return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

std::vector<Triangle> cut(const std::vector<Vertex>& vertices) {
  std::vector<std::uint32_t> corners(vertices.size());
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
  std::vector<Triangle> triangles;
  cut_polygon(vertices, corners, triangles);
  return triangles;
}

// n - 2 triangles, none turned about, have the area of the polygon: they are a partition of it.
void expect_partition(const std::vector<Vertex>& vertices, double area) {
  const std::vector<Triangle> triangles = cut(vertices);
  EXPECT_EQ(triangles.size(), vertices.size() - 2);
  double sum = 0;
  for (const Triangle& t : triangles) {
    EXPECT_GE(signed_area(vertices, t), -1e-15);
    sum += signed_area(vertices, t);
  }
  EXPECT_NEAR(sum, area, 1e-12);
}

TEST(CutPolygon, IsAPartitionOfConvexAndOfOtherPolygons) {
  expect_partition({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 1);
  expect_partition({{0, 0, 5}, {2, 1, 5}, {4, 0, 5}, {2, 4, 5}}, 6);                        // a dart
  expect_partition({{2, 1, 0}, {4, 0, 0}, {2, 4, 0}, {0, 0, 0}}, 6);                        // its dent first
  expect_partition({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}}, 5);  // an L
  std::vector<Vertex> star;
  for (int i = 0; i < 24; ++i) {
    const double r = i % 2 == 0 ? 3 : 1, t = M_PI * i / 12;
    star.push_back({r * std::cos(t), r * std::sin(t), 0});
  }
  expect_partition(star, 12 * 3 * 1 * std::sin(M_PI / 12));
}

TEST(CutPolygon, HasNothingOfPointsAndLines) {
  EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).empty());
  EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size(), 2U);
}

}  // namespace
}  // namespace raygauge::cli::test_polygon
