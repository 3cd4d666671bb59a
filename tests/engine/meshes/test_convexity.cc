// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/convexity.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "engine/sets/hull_3d.h"
#include "tests/engine/meshes/mesh_shapes.h"

namespace raygauge::test_convexity {
namespace {

using namespace testing;

HullCost cost(const MeshShape& mesh) { return hull_cost(mesh.vertices, mesh.triangles); }

TEST(HullCost, IsNothingForConvexMeshesRoundedAsFilesAreAndTurnedInsideOut) {
  EXPECT_TRUE(cost(box_shape(kZero, kOne, 5)).convex);
  MeshShape thin = box_shape(kZero, {1, 1, 1e-5}, 7);
  EXPECT_TRUE(cost(thin).convex);
  MeshShape octahedron;
  octahedron.vertices.resize(3, 6);
  octahedron.vertices << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
  for (int i = 0; i < 8; ++i) {
    const std::int32_t x = i & 1 ? 3 : 0, y = i & 2 ? 4 : 1, z = i & 4 ? 5 : 2;
    const bool odd = __builtin_popcount(static_cast<unsigned>(i)) % 2 == 1;
    octahedron.triangles.push_back({x, odd ? z : y, odd ? y : z});
  }
  EXPECT_TRUE(cost(octahedron).convex);
  for (auto& t : octahedron.triangles) std::swap(t[0], t[1]);
  EXPECT_TRUE(cost(octahedron).convex);
  MeshShape box = box_shape({0.1, 0.2, 0.3}, {0.7, 1.1, 1.3}, 6);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  box.vertices = (R * box.vertices).cast<float>().cast<double>().eval();
  EXPECT_TRUE(cost(box).convex);
}

TEST(HullCost, IsTheVolumeThatIsAdded) {
  const HullCost torus = cost(torus_shape(2, 0.5, 64, 32));
  EXPECT_FALSE(torus.convex);
  EXPECT_NEAR(torus.volume, 2 * std::numbers::pi * std::numbers::pi * 2 * 0.25, 0.1);
  if (has_hull_3d()) {
    EXPECT_GT(torus.hull_volume, 1.8 * torus.volume);
  }
  const HullCost shell = cost(joined(box_shape(kZero, 3 * kOne), box_shape(kOne, 2 * kOne, 1, true)));
  EXPECT_FALSE(shell.convex);
  EXPECT_NEAR(shell.volume, 26, 1e-12);
  if (has_hull_3d()) {
    EXPECT_NEAR(shell.hull_volume, 27, 1e-12);
  }
}

TEST(HullCost, IsThereForADentABoxOfTwoLayersAndAHole) {
  MeshShape dent = box_shape(kZero, kOne, 4);
  for (Eigen::Index i = 0; i < dent.vertices.cols(); ++i) {
    if ((dent.vertices.col(i) - Eigen::Vector3d(0.5, 0.5, 1)).norm() < 1e-9) dent.vertices(2, i) = 1 - 1e-4;
  }
  EXPECT_FALSE(cost(dent).convex);
  EXPECT_FALSE(cost(joined(box_shape(kZero, kOne), box_shape(kZero, kOne))).convex);  // winds twice
  MeshShape hole = box_shape(kZero, kOne);
  hole.triangles.pop_back();
  EXPECT_FALSE(cost(hole).convex);
  EXPECT_FALSE(cost(hole).closed);
}

TEST(HullCost, OfASheetIsItsOwnInThePlane) {
  MeshShape sheet = box_shape(kZero, kOne, 3);
  const std::vector<MeshTriangle> all = sheet.triangles;
  sheet.triangles.assign(all.begin(), all.begin() + 18);
  const auto used = [](MeshShape mesh) {  // without the vertices of the other faces
    MeshShape few;
    few.vertices.resize(3, static_cast<Eigen::Index>(3 * mesh.triangles.size()));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        few.vertices.col(static_cast<Eigen::Index>(3 * i + k)) = mesh.vertices.col(mesh.triangles[i][k]);
      const auto first = static_cast<std::int32_t>(3 * i);
      few.triangles.push_back({first, first + 1, first + 2});
    }
    return few;
  };
  EXPECT_TRUE(cost(used(sheet)).convex);
  sheet.triangles.erase(sheet.triangles.begin() + 8);
  EXPECT_FALSE(cost(used(sheet)).convex);
}

TEST(WindingNumber, CountsShells) {
  const MeshShape two = joined(box_shape(kZero, 3 * kOne), box_shape(kOne, 2 * kOne, 2));
  const auto at = [&](double x) {
    return winding_number(two.vertices, two.triangles, {x, x + 0.1, x - 0.1});
  };
  EXPECT_NEAR(at(1.5), 2, 1e-12);
  EXPECT_NEAR(at(0.5), 1, 1e-12);
  EXPECT_NEAR(at(-5), 0, 1e-12);
}

}  // namespace
}  // namespace raygauge::test_convexity
