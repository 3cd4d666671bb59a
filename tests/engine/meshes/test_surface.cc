// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/surface.h"

#include <gtest/gtest.h>

#include "tests/engine/meshes/mesh_shapes.h"

namespace raygauge::test_surface {
namespace {

using namespace testing;

SurfaceFacts facts(const MeshShape& mesh) { return surface_facts(mesh.vertices, mesh.triangles); }

TEST(SurfaceFacts, AreClosedWhereEveryEdgeIsUsedBothWaysThoughVerticesAreRepeated) {
  EXPECT_TRUE(facts(box_shape(kZero, kOne, 3)).closed());  // each square has four vertices of its own
  EXPECT_TRUE(facts(torus_shape(2, 1, 12, 8)).closed());
  MeshShape zero = box_shape(-kOne, kOne, 2);
  zero.vertices = (zero.vertices.array() == 0).select(-0.0 * zero.vertices, zero.vertices);
  zero.vertices(0, 5) += 0.0;
  EXPECT_TRUE(facts(zero).closed());
}

TEST(SurfaceFacts, NameATriangleAtAHoleAndCountItsEdges) {
  MeshShape hole = torus_shape(2, 1, 12, 8);
  hole.triangles.erase(hole.triangles.begin() + 7);
  EXPECT_EQ(facts(hole).open_edges, 3);
  MeshShape turned = torus_shape(2, 1, 12, 8);
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  EXPECT_EQ(facts(turned).open_edges, 3);
  EXPECT_EQ(facts(turned).open_triangle, 0);
}

TEST(SurfaceFacts, KnowTheParts) {
  const MeshShape one = box_shape(kZero, kOne), other = torus_shape(9, 1, 5, 4);
  const SurfaceFacts both = facts(joined(one, other));
  ASSERT_EQ(both.parts.size(), 2U);
  EXPECT_LT(both.parts[0], one.vertices.cols());
  EXPECT_GE(both.parts[1], one.vertices.cols());
}

TEST(EnclosedVolume, IsThatOfABoxLessThatOfACavity) {
  const Eigen::Vector3d low(3, -1, 2), high(5, 2, 3);
  const MeshShape box = box_shape(low, high, 4);
  EXPECT_NEAR(enclosed_volume(box.vertices, box.triangles), 6, 1e-14);
  const MeshShape shell = joined(box_shape(kZero, 3 * kOne, 2), box_shape(kOne, 2 * kOne, 1, true));
  EXPECT_NEAR(enclosed_volume(shell.vertices, shell.triangles), 26, 1e-13);
}

}  // namespace
}  // namespace raygauge::test_surface
