// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/meshes/mesh.h"
#include "tests/scene/input/robot_reading.h"

namespace raygauge::cli::test_urdf_file {
namespace {

std::string robot(const std::string& inside) { return "<robot name=\"r\">\n" + inside + "\n</robot>\n"; }

std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name=\"" + name + "\">" + inside + "</link>";
}

std::string shape(const std::string& geometry) {
  return "<collision><geometry>" + geometry + "</geometry></collision>";
}

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& inside = "", const std::string& type = "revolute") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + inside + "</joint>";
}

class UrdfFile : public testing_robots::RobotReading {
 protected:
  UrdfFile() : RobotReading("r.urdf") {}
};

TEST_F(UrdfFile, ShapesAreThoseOfCollisionsCapsulesToo) {
  const Robot robot_read =
      read(robot(link("l", shape("<capsule radius=\"0.5\" length=\"2\"/>") + shape("<sphere radius=\"3\"/>") +
                               "<collision><origin xyz=\"1 0 0\" rpy=\"0 1.5707963267948966 0\"/><geometry>"
                               "<cylinder radius=\"1\" length=\"4\"/></geometry></collision>" +
                               shape("<box size=\"2 4 6\"/>"))));
  ASSERT_EQ(robot_read.links.at(0).shapes.size(), 4U);
  const auto top = [&](std::size_t i) {
    return robot_read.links[0].shapes[i]->support_function(Eigen::Vector3d::UnitZ());
  };
  EXPECT_EQ(top(0), 1.5) << "the length of a capsule is that of its cylinder";
  EXPECT_EQ(top(1), 3);
  EXPECT_NEAR(top(2), 1, 1e-15);
  EXPECT_EQ(top(3), 3);
}

TEST_F(UrdfFile, WhatIsWrongInAVisualOrAnInertialIsNotLookedAt) {
  EXPECT_EQ(
      read(
          robot(link("l",
                     "<visual><geometry><mesh filename=\"none.dae\" scale=\"a\"/><torus/></geometry></visual>"
                     "<inertial><mass value=\"heavy\"/></inertial>" +
                         shape("<sphere radius=\"1\"/>")) +
                "<gazebo/><transmission/><material/>"))
          .links[0]
          .shapes.size(),
      1U);
}

TEST_F(UrdfFile, ACommentMayStandInFrontOfTheDeclaration) {
  EXPECT_EQ(read("<!-- made by hand -->\n<?xml version=\"1.0\"?>\n" + robot(link("l"))).links.size(), 1U);
}

TEST_F(UrdfFile, AMimicOfAMimicFollowsBoth) {
  const Robot fingers =
      read(robot(link("a") + link("b") + link("c") + link("d") + joint("j", "a", "b") +
                 joint("k", "b", "c", "<mimic joint=\"j\" multiplier=\"2\" offset=\"1\"/>") +
                 joint("l", "c", "d", "<mimic joint=\"k\" multiplier=\"-3\" offset=\"0.5\"/>")));
  EXPECT_EQ(fingers.joints, std::vector<std::string>{"j"});
  const TreeLink& last = fingers.tree.links.at(3);
  EXPECT_EQ(last.joint, 0);
  EXPECT_EQ(last.scale, -6);
  EXPECT_EQ(last.offset, -2.5);  // -3 (2 q + 1) + 0.5
  EXPECT_EQ(fingers.without_value.at("l"), "mimics 'k'");
}

TEST_F(UrdfFile, LimitsAreThoseOfTheJointWhereItHasSome) {
  const Robot arm = read(robot(link("a") + link("b") + link("c") + link("d") +
                               joint("j", "a", "b", "<limit lower=\"-1\" upper=\"2\" effort=\"1\"/>") +
                               joint("k", "b", "c", "<limit effort=\"1\"/>") +
                               joint("l", "c", "d", "<limit lower=\"0\" upper=\"0\"/>", "continuous") +
                               link("e") + joint("m", "d", "e", "<limit lower=\"-1\" upper=\"inf\"/>")));
  EXPECT_EQ(arm.links[1].lower, -1);
  EXPECT_EQ(arm.links[1].upper, 2);
  for (const int free : {0, 2, 3, 4})
    EXPECT_EQ(arm.links[static_cast<std::size_t>(free)].upper, INFINITY) << free;
}

TEST_F(UrdfFile, AMeshThatIsMissingIsLeftOutByNameOnRequest) {
  const std::string text =
      robot(link("l", shape("<mesh filename=\"a.stl\"/>") + shape("<sphere radius=\"1\"/>") +
                          shape("<mesh filename=\"package://p/b.stl\"/>")));
  EXPECT_EQ(complaint(text),
            "r.urdf:2: link 'l': there is no mesh a.stl (--skip-missing-meshes leaves it out)");
  const Robot rest = read(text, {{}, true});
  EXPECT_EQ(rest.links[0].shapes.size(), 1U);
  EXPECT_EQ(rest.skipped, (std::vector<std::string>{"a.stl of link 'l'", "package://p/b.stl of link 'l'"}));
}

TEST_F(UrdfFile, MeshesAreTakenAsAsked) {
  const std::string one = "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const std::string other = "o b\nv 3 0 0\nv 4 0 0\nv 3 1 0\nv 3 0 1\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n";
  testing::write_bytes(folder_.file("one.obj"), one);
  testing::write_bytes(folder_.file("two.obj"), one + other + "o none\n");
  const auto taken = [&](const std::string& as, const std::string& attributes) {
    return read(robot(link("l", shape("<mesh " + attributes + "/>"))), {{}, false, as});
  };
  const std::string mirrored = "filename=\"two.obj\" scale=\"-2 1 1\"";
  for (const std::string as : {"", "solid", "surface"}) {
    const Robot robot_read = taken(as, mirrored);
    ASSERT_EQ(robot_read.links[0].shapes.size(), 1U) << as;
    const Mesh* mesh = as_mesh(*robot_read.links[0].shapes[0]);
    ASSERT_NE(mesh, nullptr) << as;
    EXPECT_NEAR(mesh->volume(), as == "surface" ? 0 : 2.0 / 3, 1e-12) << as;  // of both, outside in
    EXPECT_NE(robot_read.notes.at(0).find("two.obj of link 'l'"), std::string::npos);
  }
  EXPECT_EQ(taken("hull", mirrored).links[0].shapes[0]->support_function(-Eigen::Vector3d::UnitX()), 8);
  const Robot parts = taken("parts", "filename=\"two.obj\"");
  ASSERT_EQ(parts.links[0].shapes.size(), 2U);
  EXPECT_EQ(parts.links[0].shapes[0]->support_function(Eigen::Vector3d::UnitX()), 1);
  EXPECT_NE(parts.notes.back().find("left out, for these objects have no faces: 'none'"), std::string::npos);
  EXPECT_EQ(taken("parts", "filename=\"one.obj\"").links[0].shapes.size(), 1U) << "one part";
  EXPECT_EQ(as_mesh(*taken("", "filename=\"one.obj\"").links[0].shapes[0]), nullptr) << "convex";
  EXPECT_THROW(taken("hul", mirrored), Error);
}

TEST_F(UrdfFile, MeshesAreScaledAndNamedByPackages) {
  testing::write_bytes(folder_.file("m.obj"), "v 1 0 0\nv 0 2 0\nv 0 0 4\n");
  const auto top = [&](const std::string& attributes) {
    const Robot one =
        read(robot(link("l", shape("<mesh " + attributes + "/>"))), {{{"p", folder_.path()}}, false});
    return one.links[0].shapes[0]->support_function(Eigen::Vector3d::UnitZ());
  };
  EXPECT_EQ(top("filename=\"m.obj\""), 4);
  EXPECT_EQ(top("filename=\"package://p/m.obj\" scale=\"1 1 0.5\""), 2);
  EXPECT_EQ(top("filename=\"file://" + folder_.file("m.obj") + "\""), 4);
  std::filesystem::create_directory(folder_.file("beside"));
  testing::write_bytes(folder_.file("beside/m.obj"), "v 1 0 0\nv 0 2 0\nv 0 0 3\n");
  EXPECT_EQ(top("filename=\"package://beside/m.obj\""), 3) << "without --package: the folder beside the file";
  EXPECT_EQ(complaint(robot(link("l", shape("<mesh filename=\"m.obj\" scale=\"1 1 0\"/>")))),
            "r.urdf:2: link 'l': scale = 0 leaves nothing of a mesh");
  testing::write_bytes(folder_.file("m.obj"), "v 1 0 0\nw 0 2 0\n");
  EXPECT_EQ(complaint(robot(link("l", shape("<mesh filename=\"m.obj\"/>")))),
            "r.urdf:2: link 'l': m.obj:2: 'w' is no keyword of an OBJ file");
}

TEST_F(UrdfFile, WhatIsNotUnderstoodIsNamedWithLineAndLinkOrJoint) {
  const std::string two = link("a") + link("b");
  expect_refusals({
      {"this is no XML", "r.urdf:1: not XML that can be read: "},
      {"<robot name=\"r\"><link name=\"l\"></robot>", "r.urdf:1: not XML that can be read: "},
      {robot(link("l")) + "<robot/>", "r.urdf:4: not XML that can be read: a second root element"},
      {"<html/>",
       "r.urdf:1: not a robot: its root is <html>; <robot> (URDF), <mujoco> (MJCF) and <sdf> (SDF) are read"},
      {robot("<xacro:macro name=\"a\"/>"),
       "r.urdf:2: <xacro:macro>: a xacro file; expand it first, as in: xacro r.urdf > robot.urdf"},
      {robot(""), "r.urdf:1: a robot without a link"},
      {robot("<link/>"), "r.urdf:2: <link> needs the attribute name"},
      {robot(link("a") + link("a")), "r.urdf:2: a second link 'a'"},
      {robot(two), "r.urdf:2: two links hang on no joint: 'a' and 'b'"},
      {robot(two + "\n" + joint("j", "a", "c")), "r.urdf:3: joint 'j': there is no link 'c'"},
      {robot(two + joint("j", "a", "b") + joint("j", "a", "b")), "r.urdf:2: a second joint 'j'"},
      {robot(two + joint("j", "a", "b") + joint("k", "a", "b")),
       "r.urdf:2: link 'b' hangs on a second joint, 'k'"},
      {robot(two + joint("j", "a", "b") + joint("k", "b", "a")),
       "r.urdf:1: every link hangs on a joint: they go round in a circle"},
      {robot(two + link("c") + joint("j", "a", "b") + joint("k", "b", "a")),
       "r.urdf:1: 2 links hang on joints that go round in a circle"},
      {robot(two + joint("j", "a", "b", "", "floating")),
       "r.urdf:2: joint 'j' is floating; fixed, revolute, continuous and prismatic ones are read"},
      {robot(two + joint("j", "a", "b", "<axis xyz=\"0 0 0\"/>")), "r.urdf:2: joint 'j' has no axis"},
      {robot(two + joint("j", "a", "b", "<axis xyz=\"0 0\"/>")),
       "r.urdf:2: xyz must be three finite numbers, got '0 0'"},
      {robot(two + joint("j", "a", "b", "<mimic joint=\"i\"/>")),
       "r.urdf:2: joint 'j' mimics 'i', and there is no such joint"},
      {robot(two + link("c") + joint("i", "a", "c", "", "fixed") +
             joint("j", "a", "b", "<mimic joint=\"i\"/>")),
       "r.urdf:2: joint 'j' mimics 'i', which is fixed"},
      {robot(two + joint("j", "a", "b", "<mimic joint=\"j\"/>")),
       "r.urdf:2: joint 'j' mimics 'j': mimics that go round in a circle"},
      {robot(link("l", "<collision/>")), "r.urdf:2: link 'l': a collision without a shape"},
      {robot(link("l", shape("<torus/>"))),
       "r.urdf:2: link 'l': the collision shape <torus> is not understood"},
      {robot(link("l", shape("<sphere radius=\"1\"/><box size=\"1 1 1\"/>"))),
       "r.urdf:2: link 'l': a collision of more than one shape"},
      {robot(link("l", shape("<sphere radius=\"1,5\"/>"))),
       "r.urdf:2: radius must be a finite number, got '1,5'"},
      {robot(link("l", shape("<sphere radius=\"-1\"/>"))),
       "r.urdf:2: link 'l': ball: radius must not be negative, got -1"},
      {robot(link("l", shape("<box/>"))), "r.urdf:2: <box> needs the attribute size"},
      {robot(link("l", "<colision/>")), "r.urdf:2: link 'l': <colision>; did you mean <collision>?"},
      {robot(link("l", shape("<mesh filename=\"package://p/b.stl\"/>"))),
       "r.urdf:2: link 'l': the folder of package 'p' is not known; say --package p=FOLDER"},
  });
}

}  // namespace
}  // namespace raygauge::cli::test_urdf_file
