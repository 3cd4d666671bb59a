// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// What becomes of bad meshes: one line that says what and where, or an honest surface.
#include "cli/input/mesh_object_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "tests/cli/input/mesh_text.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_mesh_object_file {
namespace {

using raygauge::testing::box_shape;
using raygauge::testing::hollow;
using raygauge::testing::kOne;
using raygauge::testing::kZero;
using raygauge::testing::MeshShape;
using raygauge::testing::obj_text;
using SetPointer = std::shared_ptr<const ConvexSet>;

class BadMeshes : public ::testing::Test {
 protected:
  std::vector<SetPointer> taken(const std::string& text, const std::string& as) {
    testing::write_bytes(folder_.file("m.obj"), text);
    notes_.clear();
    return take_mesh(read_mesh(folder_.file("m.obj")), "m.obj", as, notes_);
  }

  const Mesh* mesh(const MeshShape& shape, const std::string& as = "") {
    sets_ = taken(obj_text(shape), as);
    return as_mesh(*sets_.at(0));
  }

  std::string complaint(const std::string& text, const std::string& as = "") {
    try {
      taken(text, as);
    } catch (const Error& error) {
      std::string message = error.what();
      const std::size_t at = message.find(folder_.path() + "/");
      return at == std::string::npos ? message : message.erase(at, folder_.path().size() + 1);
    }
    return "nothing was thrown";
  }

  testing::TemporaryFolder folder_;
  Notes notes_;
  std::vector<SetPointer> sets_;
};

TEST_F(BadMeshes, WithAHoleOrATriangleTurnedAboutAreSurfacesAndNoSolids) {
  MeshShape hole = hollow(), turned = hollow(), twice = hollow();
  hole.triangles.erase(hole.triangles.begin() + 4);
  std::swap(turned.triangles[4][1], turned.triangles[4][2]);
  twice.triangles.push_back(twice.triangles[4]);
  for (const MeshShape& bad : {hole, turned, twice}) {
    const Mesh* surface = mesh(bad);
    ASSERT_NE(surface, nullptr);
    EXPECT_EQ(surface->kind(), MeshKind::surface);
    EXPECT_EQ(surface->size(), std::ssize(bad.triangles));
    EXPECT_NE(notes_.at(0).find("taken as it is, as a surface"), std::string::npos) << notes_.at(0);
    EXPECT_NE(notes_.at(0).find("bounds no volume"), std::string::npos) << notes_.at(0);
    const std::string said = complaint(obj_text(bad), "solid");
    EXPECT_EQ(said.find("m.obj: a solid needs a closed surface: 3 edges"), 0U) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

// Triangles without an area are in the surface already, and have two sides.
TEST_F(BadMeshes, WithDegenerateTrianglesAreTheSolidThatTheyAreWithoutThem) {
  MeshShape thin = hollow();
  thin.triangles.push_back({0, 1, 0});
  thin.triangles.push_back({5, 5, 5});
  for (const char* as : {"", "solid"}) {
    const Mesh* solid = mesh(thin, as);
    ASSERT_NE(solid, nullptr);
    EXPECT_EQ(solid->kind(), MeshKind::solid);
    EXPECT_NEAR(solid->volume(), 26, 1e-12);
  }
  MeshShape flat = box_shape(kZero, kOne);
  flat.triangles.assign(3, {2, 2, 2});  // nothing but points
  EXPECT_NE(mesh(flat, "surface"), nullptr);
}

TEST_F(BadMeshes, WithNumbersThatAreNoneAreRefusedWithTheirLine) {
  const std::string box = obj_text(box_shape(kZero, kOne));
  EXPECT_EQ(complaint(box + "f 1 2 99\n"), "m.obj:37: vertex 99 is not there: the file has 24");
  EXPECT_EQ(complaint("v 0 0 0\nv 1 0 nan\n").find("m.obj:2: "), 0U) << complaint("v 0 0 0\nv 1 0 nan\n");
  EXPECT_EQ(complaint("v 0 0 0\nv 1 0 1e999\n").find("m.obj"), 0U);
  EXPECT_EQ(complaint("v 0 0 0\nf 0 1 1\n").find("m.obj:2: "), 0U);
}

TEST_F(BadMeshes, WithEmptyGroupsHaveThePartsOfTheOthersAndANote) {
  MeshShape box = box_shape(kZero, kOne);
  const auto group = [](int first) {
    std::string faces;
    for (const auto& t : box_shape(kZero, kOne).triangles)
      faces += "f " + std::to_string(t[0] + first) + " " + std::to_string(t[1] + first) + " " +
               std::to_string(t[2] + first) + "\n";
    return faces;
  };
  std::string vertices = obj_text(box);
  vertices.resize(vertices.find('f'));
  MeshShape other = box_shape(4 * kOne, 5 * kOne);
  std::string more = obj_text(other);
  more.resize(more.find('f'));
  const std::string text =
      "g default\n" + vertices + more + "g a\n" + group(1) + "g nothing\ng b\n" + group(25);
  const std::vector<SetPointer> parts = taken(text, "parts");
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0]->support_function(Eigen::Vector3d::UnitX()), 1);
  EXPECT_EQ(parts[1]->support_function(Eigen::Vector3d::UnitX()), 5);
  EXPECT_EQ(notes_, (Notes{"m.obj: 2 parts, each the convex hull of an object",
                           "m.obj: left out, for these objects have no faces: 'default', 'nothing'"}));
  EXPECT_NE(complaint(vertices + "g a\n" + group(1) + "g b\n", "parts")
                .find("two objects or groups (o, g) with faces"),
            std::string::npos);
}

}  // namespace
}  // namespace raygauge::cli::test_mesh_object_file
