// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/meshes/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>
#include <string>

#include "engine/meshes/box_tree.h"
#include "engine/meshes/point_inside.h"
#include "raygauge/exceptions.h"
#include "tests/engine/meshes/mesh_shapes.h"

namespace raygauge::test_mesh {
namespace {

using namespace testing;

template <class Failure>
std::string error(const MeshShape& shape, MeshKind kind = MeshKind::surface) {
  try {
    Mesh(shape.vertices, shape.triangles, kind);
  } catch (const Failure& caught) {
    return caught.what();
  }
  return "nothing was thrown";
}

TEST(Mesh, RefusesWhatIsNoMeshAndNamesThePlace) {
  MeshShape box = box_shape(kZero, kOne);
  EXPECT_EQ(error<EmptySetError>({box.vertices, {}}), "a mesh needs at least one triangle");
  MeshShape index = box;
  index.triangles[3][1] = 24;
  EXPECT_EQ(error<InvalidParameterError>(index), "triangle 3 names vertex 24; there are 24, counted from 0");
  MeshShape nan = box;
  nan.vertices(2, 5) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error<NonFiniteError>(nan), "coordinate 2 of vertex 5 is not a finite number");
  MeshShape hole = box;
  hole.triangles.erase(hole.triangles.begin());
  EXPECT_EQ(
      error<InvalidParameterError>(hole, MeshKind::solid),
      "a solid needs a closed surface: 3 edges have no triangle on the other side, or one that is turned "
      "about, the first at triangle 0");
  EXPECT_NO_THROW(Mesh(hole.vertices, hole.triangles));
}

// Whether x - center is a combination of the axes within the halves: solved in doubles, which know it to
// 1e-15.
bool holds(const BoxNode& box, const Vector3& x) {
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) axes(i, k) = double{box.axis[k][i]};
  }
  const Eigen::Vector3d way(x.x - double{box.center[0]}, x.y - double{box.center[1]},
                            x.z - double{box.center[2]});
  const Eigen::Vector3d z = axes.partialPivLu().solve(way);
  for (int k = 0; k < 3; ++k) {
    if (!(std::fabs(z[k]) <= double{box.half[k]})) return false;
  }
  return true;
}

// Every triangle is in the box of each node above it, and in one leaf.
TEST(BoxTree, HoldsEveryTriangleOnceInItsBoxes) {
  for (const int threads : {1, 3}) {
    const MeshShape torus = torus_shape(1e3, 0.1, 150, 37);
    const BoxTree tree(torus.vertices, torus.triangles, threads);
    std::vector<int> seen(torus.triangles.size());
    std::vector<std::vector<std::int32_t>> open = {{0}};  // nodes from the root on
    while (!open.empty()) {
      std::vector<std::int32_t> path = open.back();
      open.pop_back();
      const BoxNode& box = tree.node(path.back());
      if (!box.is_leaf()) {
        for (const std::int32_t child : {path.back() + 1, box.next}) {
          open.push_back(path);
          open.back().push_back(child);
        }
        continue;
      }
      for (std::int32_t t = box.next; t < box.next + box.count; ++t) {
        const auto number = static_cast<std::size_t>(tree.number_of(t));
        ++seen[number];
        for (std::size_t c = 0; c < 3; ++c) {
          const Vector3 p = tree.triangle(t).corner[c];
          ASSERT_EQ(p.x, torus.vertices(0, torus.triangles[number][c]));
          for (const std::int32_t node : path) ASSERT_TRUE(holds(tree.node(node), p));
        }
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ssize(seen));
    EXPECT_LE(tree.memory(), 200 * tree.size());
  }
}

TEST(PointInside, CountsEdgesAndVerticesOnTheRayOnce) {
  const MeshShape box = box_shape(kZero, 4 * kOne, 4);
  const BoxTree tree(box.vertices, box.triangles, 1);
  for (int x = -1; x <= 9; ++x) {
    for (int y = -1; y <= 9; ++y) {
      for (int z = -1; z <= 9; ++z) {
        const Vector3 p{x / 2.0, y / 2.0, z / 2.0};  // rays hit edges, vertices and run along faces
        const auto within = [](double c) { return c > 0 && c < 4; };
        const auto at_most = [](double c) { return c >= 0 && c <= 4; };
        const bool inside = within(p.x) && within(p.y) && within(p.z);
        if (!inside && at_most(p.x) && at_most(p.y) && at_most(p.z)) continue;  // on the surface
        EXPECT_EQ(point_inside(tree, p), inside ? Inside::yes : Inside::no) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

}  // namespace
}  // namespace raygauge::test_mesh
