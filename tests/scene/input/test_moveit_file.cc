// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/moveit_file.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_moveit_file {
namespace {

constexpr const char* kPose =
    "position: [1, 2, 3], orientation: [0, 0, 0.7071067811865476, 0.7071067811865476]";

class MoveItFile : public ::testing::Test {
 protected:
  MoveItScene read(const std::string& text) const {
    testing::write_bytes(folder_.file("scene.yaml"), text);
    return read_moveit_scene(folder_.file("scene.yaml"));
  }

  static std::string object(const std::string& inside) {
    return "world:\n  collision_objects:\n    - {id: a, " + inside + "}\n";
  }

  static std::string primitive(const std::string& inside) {
    return object("primitives: [{" + inside + "}], primitive_poses: [{" + kPose + "}]");
  }

  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const Error& error) {
      return std::string(error.what()).substr(folder_.path().size() + 1);
    }
    return "nothing was thrown";
  }

  testing::TemporaryFolder folder_;
};

double top(const MoveItScene& scene, const Eigen::Vector3d& u) {
  return scene.obstacles.at(0).parts.at(0).set->support_function(u);
}

TEST_F(MoveItFile, PrimitivesAndMeshesStandAtTheirPoses) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const MoveItScene box = read(primitive("type: box, dimensions: [2, 4, 6]"));
  EXPECT_EQ(box.obstacles[0].name, "a");
  EXPECT_NEAR(top(box, x), 1 + 2, 1e-15);  // turned by a quarter about z
  EXPECT_NEAR(top(box, y), 2 + 1, 1e-15);
  EXPECT_NEAR(top(box, z), 3 + 3, 1e-15);
  const MoveItScene cylinder = read(primitive("dimensions: [4, 0.5], type: cylinder"));
  EXPECT_NEAR(top(cylinder, z), 3 + 2, 1e-15);
  EXPECT_NEAR(top(cylinder, y), 2 + 0.5, 1e-15);
  EXPECT_NEAR(top(read(primitive("type: sphere, dimensions: [0.25]")), x), 1.25, 1e-15);
  const MoveItScene mesh =
      read(object("meshes: [{vertices: [[1, 0, 0], {x: 0, y: 1, z: 0}, [0, 0, 2]]}], mesh_poses: [{" +
                  std::string(kPose) + "}]"));
  EXPECT_NEAR(top(mesh, y), 2 + 1, 1e-15);
  EXPECT_NEAR(top(mesh, z), 3 + 2, 1e-15);
}

TEST_F(MoveItFile, ThePoseOfAnObjectMovesItsPrimitives) {
  const MoveItScene scene =
      read(object("pose: {position: [10, 0, 0], orientation: [0, 0, 0, 1]}, primitives: [{type: sphere, "
                  "dimensions: [1]}], primitive_poses: [{" +
                  std::string(kPose) + "}]"));
  EXPECT_NEAR(top(scene, Eigen::Vector3d::UnitX()), 12, 1e-14);
}

TEST_F(MoveItFile, PairsThatMayTouchAreThoseOfTheMatrix) {
  const MoveItScene scene = read(
      "world: {}\nallowed_collision_matrix:\n  entry_names: [a, b, c]\n  entry_values: [[false, true, "
      "false], [true, "
      "false, false], [false, false, false]]\n");
  EXPECT_EQ(scene.allowed, (std::vector<std::pair<std::string, std::string>>{{"a", "b"}}));
  EXPECT_TRUE(scene.obstacles.empty());
}

TEST_F(MoveItFile, ARequestHasStartGoalAndGroup) {
  testing::write_bytes(folder_.file("r.yaml"),
                       "group_name: arm\nstart_state: {joint_state: {name: [j, k], position: [0.5, -1]}}\n"
                       "goal_constraints: [{joint_constraints: [{position: 2, joint_name: k}]}]\n");
  const MoveItRequest request = read_moveit_request(folder_.file("r.yaml"));
  EXPECT_EQ(request.group, "arm");
  EXPECT_EQ(request.start, (std::map<std::string, double>{{"j", 0.5}, {"k", -1}}));
  EXPECT_EQ(request.goal, (std::map<std::string, double>{{"k", 2}}));
}

TEST_F(MoveItFile, WhatIsNotUnderstoodIsRefusedInOneLine) {
  EXPECT_EQ(complaint(primitive("type: cone, dimensions: [1, 2]")),
            "scene.yaml:3: the primitive 'cone' is not understood");
  EXPECT_EQ(complaint(primitive("type: box, dimensions: [1, 2]")), "scene.yaml:3: 3 numbers must stand here");
  EXPECT_EQ(complaint(primitive("type: sphere, dimensions: [.nan]")),
            "scene.yaml:3: a finite number must stand here");
  EXPECT_EQ(complaint(object("planes: [{coef: [1, 0, 0, 0]}]")), "scene.yaml:3: planes are not understood");
  EXPECT_EQ(complaint(object("primitives: [{type: box}]")), "scene.yaml:3: there is no primitive_poses");
  EXPECT_EQ(complaint("name: s\n"), "scene.yaml:1: there is no world");
  EXPECT_EQ(complaint("world: nothing\n"), "scene.yaml:1: keys must stand here");
  EXPECT_EQ(complaint("world: [{collision_objects: []}]\n"), "scene.yaml:1: keys must stand here");
  EXPECT_EQ(complaint("world: {}\nrobot_state: {attached_collision_objects: [{link_name: hand}]}\n"),
            "scene.yaml:2: attached_collision_objects are not understood");
  EXPECT_EQ(complaint("world: [\n").substr(0, 42), "scene.yaml:2: not YAML that can be read: e");
}

}  // namespace
}  // namespace raygauge::cli::test_moveit_file
