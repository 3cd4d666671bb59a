// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "raygauge/sets/half_space.h"
#include "tests/scene/input/robot_reading.h"

namespace raygauge::cli::test_mjcf_file {
namespace {

using Eigen::Vector3d;
using testing_robots::expect_near;
using testing_robots::names_of;
using testing_robots::place_of;
using testing_robots::reach;

class MjcfFile : public testing_robots::RobotReading {
 protected:
  MjcfFile() : RobotReading("m.xml") {}
};

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

std::string model(const std::string& bodies, const std::string& before = "") {
  return "<mujoco model=\"m\">\n" + before + "<worldbody>" + bodies + "</worldbody></mujoco>\n";
}

TEST_F(MjcfFile, GeomsAreOfTheirTypeAndSize) {
  const Robot robot = read(model(
      "<body name=\"b\"><geom size=\"2\"/><geom type=\"box\" size=\"1 2 3\" pos=\"1 0 0\"/>"
      "<geom type=\"capsule\" size=\"0.5 1\"/><geom type=\"cylinder\" size=\"1 2\" euler=\"0 90 0\"/>"
      "<geom type=\"ellipsoid\" size=\"1 2 3\"/><geom type=\"capsule\" fromto=\"0 0 0 0 4 0\" size=\"0.5\"/>"
      "<geom type=\"box\" fromto=\"0 0 0 0 0 4\" size=\"1\"/></body>"));
  EXPECT_EQ(names_of(robot), (std::vector<std::string>{"world", "b"}));
  EXPECT_EQ(reach(robot, "b", kX, 0), 2);
  EXPECT_EQ(reach(robot, "b", kX, 1), 2);
  EXPECT_EQ(reach(robot, "b", kZ, 1), 3);
  EXPECT_EQ(reach(robot, "b", kZ, 2), 1.5);
  EXPECT_NEAR(reach(robot, "b", kX, 3), 2, 1e-15);
  EXPECT_NEAR(reach(robot, "b", kY, 4), 2, 1e-15);
  EXPECT_NEAR(reach(robot, "b", kY, 5), 4.5, 1e-15);
  EXPECT_NEAR(reach(robot, "b", -kY, 5), 0.5, 1e-15);
  EXPECT_NEAR(reach(robot, "b", kZ, 6), 4, 1e-15);
  EXPECT_NEAR(reach(robot, "b", kX, 6), 1, 1e-15);
}

TEST_F(MjcfFile, AJointTurnsAboutItsOwnPointByDegreesUnlessTheFileSaysRadians) {
  const std::string bodies =
      "<body name=\"a\" pos=\"1 0 0\"><geom size=\"1\"/><joint name=\"j\" axis=\"0 0 1\" pos=\"0 1 0\" "
      "range=\"-90 180\"/><body name=\"b\" pos=\"0 0 2\"><geom size=\"1\"/><joint name=\"k\" type=\"slide\" "
      "axis=\"1 0 0\" range=\"0 3\"/></body></body>";
  const Robot robot = read(model(bodies));
  EXPECT_EQ(robot.joints, (std::vector<std::string>{"j", "k"}));
  EXPECT_EQ(names_of(robot), (std::vector<std::string>{"world", "a@j", "a", "b"}));
  EXPECT_NEAR(robot.links[1].lower, -M_PI / 2, 1e-15);
  EXPECT_EQ(robot.links[3].upper, 3);
  const Eigen::Vector2d values(M_PI / 2, 0.5);
  expect_near(place_of(robot, "a"), Vector3d::Zero(), {1, 0, 0});
  expect_near(place_of(robot, "a", values), Vector3d::Zero(), {2, 1, 0});
  expect_near(place_of(robot, "b", values), Vector3d::Zero(), {2, 1.5, 2});
  const Robot radians = read(model(bodies, "<compiler angle=\"radian\"/>"));
  EXPECT_EQ(radians.links[1].lower, -90);
  EXPECT_EQ(read(model(bodies, "<compiler autolimits=\"false\"/>")).links[1].lower, -INFINITY);
}

TEST_F(MjcfFile, TheValueOfAJointIsRefInThePoseOfTheFile) {
  const Robot robot =
      read(model("<body name=\"a\"><geom size=\"1\"/><joint name=\"j\" axis=\"1 0 0\" "
                 "type=\"slide\" ref=\"2\" range=\"1 5\"/></body>"));
  const auto at = [&](double value) {
    return place_of(robot, "a", Eigen::VectorXd::Constant(1, value)).t[0];
  };
  EXPECT_EQ(at(2), 0);
  EXPECT_EQ(at(5), 3);
  const JointLimits limits = limits_of(robot).at(0);
  EXPECT_EQ(limits.lower, 1);
  EXPECT_EQ(limits.upper, 5);
}

TEST_F(MjcfFile, OrientationsAreReadInEveryWay) {
  const auto image = [&](const std::string& orientation, const std::string& compiler = "") {
    const Robot robot =
        read(model("<body name=\"a\" " + orientation + "><geom size=\"1\"/></body>", compiler));
    const Placement place = place_of(robot, "a");
    return Vector3d(place.R * kX);
  };
  const double r = std::sqrt(0.5);
  EXPECT_LT((image("quat=\"1 0 0 1\"") - kY).norm(), 1e-15);
  EXPECT_LT((image("axisangle=\"0 0 2 90\"") - kY).norm(), 1e-15);
  EXPECT_LT((image("xyaxes=\"1 1 0 -1 1 0\"") - Vector3d(r, r, 0)).norm(), 1e-15);
  EXPECT_LT((image("zaxis=\"1 0 0\"") + kZ).norm(), 1e-15);
  EXPECT_LT((image("euler=\"0 0 90\"") - kY).norm(), 1e-15);
  // z turns x to y; an axis x that turned along leaves y where it is, one of the space turns it to z.
  EXPECT_LT((image("euler=\"90 90 0\"", "<compiler eulerseq=\"zxy\"/>") - kY).norm(), 1e-15);
  EXPECT_LT((image("euler=\"90 90 0\"", "<compiler eulerseq=\"ZXY\"/>") - kZ).norm(), 1e-15);
}

TEST_F(MjcfFile, DefaultsAreThoseOfTheClassOfTheElementOrOfTheBody) {
  const Robot robot =
      read(model("<body name=\"a\" childclass=\"inner\"><geom/><geom class=\"main\"/><geom size=\"7\"/>"
                 "<body name=\"b\"><geom/></body><body name=\"c\" childclass=\"main\"><geom/></body></body>",
                 "<default><geom size=\"3\"/><default class=\"outer\"><geom size=\"4\" pos=\"1 0 0\"/>"
                 "<default class=\"inner\"><geom size=\"5\"/></default></default></default>"));
  EXPECT_EQ(reach(robot, "a", kX, 0), 6);
  EXPECT_EQ(reach(robot, "a", kX, 1), 3);
  EXPECT_EQ(reach(robot, "a", kX, 2), 8);
  EXPECT_EQ(reach(robot, "b", kX), 6);
  EXPECT_EQ(reach(robot, "c", kX), 3);
}

TEST_F(MjcfFile, MeshesAreScaledAndFoundInTheirFolderOrWritten) {
  std::filesystem::create_directory(folder_.file("assets"));
  write("assets/part.obj", "v 1 0 0\nv 0 2 0\nv 0 0 4\n");
  const std::string bodies = "<body name=\"a\"><geom type=\"mesh\" mesh=\"part\" pos=\"0 0 1\"/></body>";
  const auto assets = [](const std::string& mesh) {
    return "<compiler meshdir=\"assets\"/><default><mesh scale=\"1 1 0.5\"/></default><asset>" + mesh +
           "</asset>";
  };
  EXPECT_EQ(reach(read(model(bodies, assets("<mesh file=\"part.obj\"/>"))), "a", kZ), 3);
  const std::string written = "<mesh name=\"part\" vertex=\"0 0 0\n1 0 0\r\n0 1 0  0 0 8\"/>";
  EXPECT_EQ(reach(read(model(bodies, assets(written))), "a", kZ), 5);
  EXPECT_EQ(complaint(model(bodies, assets("<mesh name=\"part\" file=\"gone.stl\"/>"))),
            "m.xml:2: link 'a': there is no mesh assets/gone.stl (--skip-missing-meshes leaves it out)");
  write("assets/part.obj", "v 1 0 0\nv 0 nan 0\n");
  EXPECT_EQ(complaint(model(bodies, assets("<mesh file=\"part.obj\"/>"))).substr(0, 40),
            "m.xml:2: link 'a': assets/part.obj:2: 'n");
}

TEST_F(MjcfFile, IncludedFilesStandInThePlaceOfTheirElement) {
  write("inner.xml", "<mujocoinclude><body name=\"b\" pos=\"0 0 3\"><geom/></body></mujocoinclude>");
  write("sizes.xml", "<mujoco><default><geom size=\"2\"/></default></mujoco>");
  const std::string include = "<include file=\"inner.xml\"/>";
  const Robot robot =
      read(model("<body name=\"a\" pos=\"1 0 0\">" + include + "</body>", "<include file=\"sizes.xml\"/>"));
  expect_near(place_of(robot, "b"), Vector3d::Zero(), {1, 0, 3});
  EXPECT_EQ(reach(robot, "b", kX), 2);
  write("inner.xml", "<mujocoinclude>\n<geom size=\"-1\"/></mujocoinclude>");
  EXPECT_EQ(complaint(model(include)).substr(0, 12), "inner.xml:2:") << "the line of the included file";
  EXPECT_EQ(complaint(model(include + include)), "m.xml:2: inner.xml is included a second time");
  write("inner.xml", "<mujocoinclude><include file=\"inner.xml\"/></mujocoinclude>");
  EXPECT_EQ(complaint(model(include)), "inner.xml:1: inner.xml is included a second time");
}

TEST_F(MjcfFile, WhatIsLeftOutIsNamed) {
  const Robot robot = read(model(
      "<geom name=\"floor\" type=\"plane\" size=\"0 0 1\"/>"
      "<body name=\"a\" pos=\"0 0 1\"><freejoint/><geom size=\"1\"/><geom contype=\"0\" conaffinity=\"0\" "
      "type=\"mesh\" mesh=\"none\"/><body name=\"b\"><joint name=\"s\" type=\"ball\" range=\"0 30\"/>"
      "<geom size=\"1\"/></body><body name=\"c\"><geom size=\"1\"/></body></body>",
      "<contact><exclude body1=\"b\" body2=\"c\"/></contact>"
      "<equality><weld body1=\"a\" body2=\"b\"/></equality>"));
  EXPECT_EQ(
      lines_of_left_out(robot),
      std::vector<std::string>{"left out: the free joint of body 'a', which stays where it stands; the limit "
                               "of the ball joint 's'; 1 geom without contacts (contype and conaffinity 0); "
                               "1 equality constraint"});
  EXPECT_EQ(robot.joints, (std::vector<std::string>{"s_x", "s_y", "s_z"}));
  ASSERT_EQ(names_of(robot).at(1), "floor");
  EXPECT_NE(as_half_space(*robot.links[1].shapes.at(0)), nullptr);
  EXPECT_EQ(robot.tree.links[2].parent, -1) << "a body that is free is not joined to the world";
  const std::vector<std::string> names = names_of(robot);
  ASSERT_EQ(robot.apart.size(), 1U);
  EXPECT_EQ(names[static_cast<std::size_t>(robot.apart[0].first)], "b");
}

TEST_F(MjcfFile, JointsThatAreCoupledFollowEachOther) {
  const std::string fingers =
      "<body name=\"a\"><geom size=\"1\"/><joint name=\"l\" type=\"slide\" axis=\"1 0 0\" ref=\"1\"/></body>"
      "<body name=\"b\"><geom size=\"1\"/><joint name=\"f\" type=\"slide\" axis=\"1 0 0\"/></body>";
  const Robot robot = read(
      model(fingers, "<equality><joint joint1=\"f\" joint2=\"l\" polycoef=\"0.5 -2 0 0 0\"/></equality>"));
  EXPECT_EQ(robot.joints, std::vector<std::string>{"l"});
  EXPECT_EQ(robot.without_value.at("f"), "mimics 'l'");
  EXPECT_EQ(place_of(robot, "b", Eigen::VectorXd::Constant(1, 3)).t[0], 0.5 - 2 * (3 - 1));
}

TEST_F(MjcfFile, WhatIsNotUnderstoodIsNamedWithFileAndLine) {
  const std::string ball = "<geom size=\"1\"/>";
  expect_refusals({
      {model("<body name=\"a\"/><body name=\"a\"/>"), "m.xml:2: a second link 'a'"},
      {model("<body name=\"a\"><geon/></body>"), "m.xml:2: <geon> in body 'a' is not read"},
      {model("<body name=\"a\"><replicate count=\"2\"/></body>"),
       "m.xml:2: <replicate> in body 'a' is not read"},
      {model("<geom type=\"hfield\"/>"), "m.xml:2: link 'world': a geom of type hfield is not read"},
      {model("<geom size=\"nan\"/>"), "m.xml:2: size must be finite numbers, got 'nan'"},
      {model("<geom class=\"c\"/>"), "m.xml:2: there is no default class 'c'"},
      {model("<geom mesh=\"part\"/>"), "m.xml:2: link 'world': there is no mesh 'part'"},
      {model("<body><joint axis=\"0 0 0\"/>" + ball + "</body>"),
       "m.xml:2: joint 'body 1 joint 1' has no axis"},
      {model("<body name=\"a\"><body name=\"b\"><freejoint/></body></body>"),
       "m.xml:2: body 'b' has a free joint, and another one or a body around it"},
      {model(ball, "<compiler eulerseq=\"xy\"/>"),
       "m.xml:2: eulerseq must be three of x, y, z, X, Y and Z, got 'xy'"},
      {model(ball, "<compiler coordinate=\"global\"/>"), "m.xml:2: coordinate = global is not read"},
      {model("<geom type=\"mesh\" mesh=\"p\"/>",
             "<asset><mesh name=\"p\" vertex=\"0 0 0 1 0 0 0 1 0\" face=\"0 1 3\"/></asset>"),
       "m.xml:2: link 'world': face names a vertex that is not there"},
      {model(ball, "<include file=\"gone.xml\"/>"), "m.xml:2: there is no file gone.xml"},
      {model(ball, "<contact><exclude body1=\"x\" body2=\"world\"/></contact>"),
       "m.xml:2: there is no body 'x'"},
      {model("<geom type=\"capsule\" fromto=\"0 0 0 0 0\" size=\"1\"/>"),
       "m.xml:2: fromto has 5 numbers, 6 are expected"},
  });
}

}  // namespace
}  // namespace raygauge::cli::test_mjcf_file
