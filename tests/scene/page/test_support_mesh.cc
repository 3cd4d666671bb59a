// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/support_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::test_support_mesh {
namespace {

using Eigen::Vector3d;

/// By the divergence theorem; right only where the surface is closed and its triangles turn the right way.
double volume(const SupportMesh& mesh) {
  double six = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&](int k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
    six += at(a).dot(at(b).cross(at(c)));
  }
  return six / 6;
}

/// Each edge belongs to two triangles that pass it in opposite directions.
bool is_closed(const SupportMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges)
    if (count != 1 || edges.count({edge.second, edge.first}) == 0) return false;
  return true;
}

Eigen::MatrixXd cube_with_points_on_its_faces() {
  Eigen::MatrixXd points(3, 27);
  for (int i = 0; i < 27; ++i) points.col(i) << i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1;
  return points;
}

TEST(SupportMesh, OfABoxAreItsEightCorners) {
  const Box box(Vector3d(-1, -2, -3), Vector3d(2, 2, 1));
  const SupportMesh mesh = support_mesh(box, 1e-3, 1000);
  EXPECT_EQ(mesh.vertices.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume(mesh), 48, 1e-12);
}

TEST(SupportMesh, OfPointsIsTheirHull) {
  const PointSet cube(cube_with_points_on_its_faces());
  const SupportMesh mesh = support_mesh(cube, 1e-3, 1000);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume(mesh), 8, 1e-12);
  Eigen::MatrixXd cloud(3, 500);
  cloud.setRandom();
  const SupportMesh hull = support_mesh(PointSet(cloud), 1e-9, 1000);
  EXPECT_TRUE(is_closed(hull));
  for (const auto& [a, b, c] : hull.triangles) {
    const auto at = [&](int k) { return hull.vertices[static_cast<std::size_t>(k)]; };
    const Vector3d normal = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    EXPECT_LE((normal.transpose() * cloud).maxCoeff() - normal.dot(at(a)), 1e-8);
  }
}

TEST(SupportMesh, OfRoundBodiesIsFine) {
  constexpr double kPi = std::numbers::pi;
  constexpr double kFineness = 1e-3;
  constexpr double kShare = 0.02;  // of the volume: a surface within 1e-3 of the size everywhere
  const Ball ball(Vector3d(1, 2, 3), 0.5);
  const Capsule capsule(Vector3d(0, 0, 0), Vector3d(0, 0, 2), 0.5);
  const Cylinder cylinder(Vector3d(0, 0, 0), Vector3d(0, 0, 2), 0.5);
  const std::pair<const ConvexSet*, double> cases[] = {
      {&ball, kPi / 6}, {&capsule, kPi / 6 + kPi / 2}, {&cylinder, kPi / 2}};
  for (const auto& [set, truth] : cases) {
    const SupportMesh mesh = support_mesh(*set, kFineness, 3000);
    EXPECT_TRUE(is_closed(mesh));
    EXPECT_LE(volume(mesh), truth);
    EXPECT_GE(volume(mesh), (1 - kShare) * truth);
  }
}

TEST(SupportMesh, OfAFlatBodyHasAThickness) {
  Eigen::MatrixXd square(3, 4);
  square << 0, 1, 1, 0, 0, 0, 1, 1, 2, 2, 2, 2;
  const SupportMesh mesh = support_mesh(PointSet(square), 1e-3, 1000);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_GT(volume(mesh), 0);
  EXPECT_LT(volume(mesh), 0.01);
}

TEST(SupportMesh, IsNoLargerThanAsked) {
  EXPECT_LE(support_mesh(Ball(Vector3d::Zero(), 1), 1e-9, 100).vertices.size(), 100U);
}

TEST(SupportPolygon, OfABoxAreItsFourCornersAndOfADiscIsFine) {
  EXPECT_EQ(support_polygon(Box(Eigen::Vector2d(-1, -2), Eigen::Vector2d(3, 4)), 1e-3, 100).size(), 4U);
  const auto disc = support_polygon(Ball(Eigen::Vector2d(1, 1), 2), 1e-3, 1000);
  double area = 0;
  for (std::size_t i = 0; i < disc.size(); ++i) {
    const Eigen::Vector2d &p = disc[i], &q = disc[(i + 1) % disc.size()];
    area += (p.x() * q.y() - p.y() * q.x()) / 2;
  }
  EXPECT_NEAR(area, 4 * std::numbers::pi, 0.05);
  EXPECT_EQ(support_polygon(Ball(Eigen::Vector2d(1, 1), 0), 1e-3, 100).size(), 1U);
}

}  // namespace
}  // namespace raygauge::test_support_mesh
