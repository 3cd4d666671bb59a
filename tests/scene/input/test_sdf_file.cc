// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "raygauge/sets/half_space.h"
#include "tests/scene/input/robot_reading.h"

namespace raygauge::cli::test_sdf_file {
namespace {

using Eigen::Vector3d;
using testing_robots::expect_near;
using testing_robots::names_of;
using testing_robots::place_of;
using testing_robots::reach;

class SdfFile : public testing_robots::RobotReading {
 protected:
  SdfFile() : RobotReading("m.sdf") {}
};

const Vector3d kX = Vector3d::UnitX(), kY = Vector3d::UnitY(), kZ = Vector3d::UnitZ();

std::string model(const std::string& inside, const std::string& version = "1.9") {
  return "<sdf version=\"" + version + "\">\n<model name=\"m\">" + inside + "</model></sdf>\n";
}

std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name=\"" + name + "\">" + inside + "</link>";
}

std::string shape(const std::string& geometry, const std::string& pose = "") {
  return "<collision name=\"c\">" + pose + "<geometry>" + geometry + "</geometry></collision>";
}

std::string joint(const std::string& inside, const std::string& type = "revolute") {
  return "<joint name=\"j\" type=\"" + type + "\"><parent>a</parent><child>b</child>" + inside + "</joint>";
}

std::string axis(const std::string& xyz, const std::string& inside = "") {
  return "<axis><xyz>" + xyz + "</xyz>" + inside + "</axis>";
}

TEST_F(SdfFile, ShapesAreThoseOfCollisions) {
  const Robot robot =
      read(model(link("l", "<visual name=\"v\"><geometry><mesh/></geometry></visual>" +
                               shape("<box><size>2 4 6</size></box>", "<pose>1 0 0 0 0 0</pose>") +
                               shape("<sphere><radius> 3 </radius></sphere>") +
                               shape("<cylinder><radius>1</radius><length>4</length></cylinder>",
                                     "<pose degrees=\"true\">0 0 0 0 90 0</pose>") +
                               shape("<capsule><radius>0.5</radius><length>2</length></capsule>") +
                               shape("<ellipsoid><radii>1 2 3</radii></ellipsoid>") + shape("<empty/>"))));
  EXPECT_EQ(robot.name, "m");
  EXPECT_EQ(reach(robot, "l", kX, 0), 2);
  EXPECT_EQ(reach(robot, "l", kX, 1), 3);
  EXPECT_NEAR(reach(robot, "l", kX, 2), 2, 1e-15);
  EXPECT_EQ(reach(robot, "l", kZ, 3), 1.5);
  EXPECT_NEAR(reach(robot, "l", kY, 4), 2, 1e-15);
  EXPECT_EQ(robot.links[0].shapes.size(), 5U);
}

TEST_F(SdfFile, AJointIsInTheFrameOfItsChildAndPosesInThatOfTheModel) {
  const Robot robot =
      read(model("<pose>0 0 10 0 0 0</pose>" + link("a", "<pose>1 0 0 0 0 0</pose>") +
                 link("b", "<pose>3 0 0 0 0 1.5707963267948966</pose>") +
                 joint("<pose>0 1 0 0 0 0</pose>" + axis("0 0 1", "<limit><lower>-1</lower></limit>"))));
  EXPECT_EQ(names_of(robot), (std::vector<std::string>{"a", "b@j", "b"}));
  expect_near(place_of(robot, "a"), Vector3d::Zero(), {1, 0, 10});
  expect_near(place_of(robot, "b"), kX, {3, 1, 10});
  // The joint is at (2, 0, 10): a quarter turn moves b's origin from (3, 0, 10) to (2, 1, 10).
  expect_near(place_of(robot, "b", Eigen::VectorXd::Constant(1, M_PI / 2)), Vector3d::Zero(), {2, 1, 10});
  EXPECT_EQ(robot.links[1].lower, -1);
  EXPECT_EQ(robot.links[1].upper, INFINITY);
}

TEST_F(SdfFile, AxesMayBeExpressedInOtherFrames) {
  const std::string links = link("a") + link("b", "<pose>0 0 0 0 0 1.5707963267948966</pose>");
  const auto moved = [&](const std::string& axis, const std::string& version = "1.9") {
    const Robot robot = read(model(links + joint(axis, "prismatic"), version));
    return Vector3d(place_of(robot, "b", Eigen::VectorXd::Constant(1, 2)).t);
  };
  EXPECT_LT((moved("<axis><xyz>1 0 0</xyz></axis>") - 2 * kY).norm(), 1e-15);
  EXPECT_LT((moved("<axis><xyz expressed_in=\"__model__\">1 0 0</xyz></axis>") - 2 * kX).norm(), 1e-15);
  EXPECT_LT((moved("<axis><xyz expressed_in=\"a\">1 0 0</xyz></axis>") - 2 * kX).norm(), 1e-15);
  EXPECT_LT((moved("<axis><xyz>1 0 0</xyz></axis>", "1.4") - 2 * kX).norm(), 1e-15);
  EXPECT_LT((moved("<axis><xyz>1 0 0</xyz><use_parent_model_frame>1</use_parent_model_frame></axis>", "1.6") -
             2 * kX)
                .norm(),
            1e-15);
}

TEST_F(SdfFile, FramesNestedModelsAndIncludesAreResolved) {
  std::filesystem::create_directory(folder_.file("hand"));
  write("hand/model.sdf",
        "<sdf version=\"1.9\"><model name=\"hand\"><link name=\"palm\"><pose>0 0 1 0 0 0</pose>" +
            shape("<mesh><uri>model://hand/m.obj</uri><scale>1 1 2</scale></mesh>") +
            "</link></model></sdf>");
  write("hand/m.obj", "v 1 0 0\nv 0 2 0\nv 0 0 4\n");
  const Robot robot =
      read(model(link("a") +
                 "<frame name=\"tip\" attached_to=\"a\"><pose>5 0 0 0 0 0</pose></frame>"
                 "<model name=\"sub\"><pose relative_to=\"tip\">0 1 0 0 0 0</pose>" +
                 link("b") +
                 "</model>"
                 "<include><uri>model://hand</uri><name>left</name><pose relative_to=\"tip\">0 0 2 0 0 "
                 "0</pose></include>"
                 "<joint name=\"j\" type=\"fixed\"><parent>tip</parent><child>left::palm</child></joint>"));
  EXPECT_EQ(names_of(robot), (std::vector<std::string>{"a", "left::palm", "sub::b"}));
  expect_near(place_of(robot, "sub::b"), Vector3d::Zero(), {5, 1, 0});
  expect_near(place_of(robot, "left::palm"), Vector3d::Zero(), {5, 0, 3});
  EXPECT_EQ(robot.tree.links[1].parent, 0) << "a frame stands for the link that it is attached to";
  EXPECT_EQ(reach(robot, "left::palm", kZ), 8);
}

TEST_F(SdfFile, AModelStandsForItsCanonicalLinkInAJoint) {
  const auto parent = [&](const std::string& attributes, const std::string& name) {
    const Robot robot =
        read(model(link("a") + "<frame name=\"f\"/><model name=\"sub\"" + attributes + ">" + link("b") +
                   link("c") + "</model>" + link("d") + "<joint name=\"j\" type=\"fixed\"><parent>" + name +
                   "</parent><child>d</child></joint>"));
    const std::vector<std::string> names = names_of(robot);
    const auto d = std::find(names.begin(), names.end(), "d") - names.begin();
    return names.at(static_cast<std::size_t>(robot.tree.links[static_cast<std::size_t>(d)].parent));
  };
  EXPECT_EQ(parent("", "__model__"), "a");
  EXPECT_EQ(parent("", "f"), "a");
  EXPECT_EQ(parent("", "sub"), "sub::b");
  EXPECT_EQ(parent(" canonical_link=\"c\"", "sub"), "sub::c");
}

TEST_F(SdfFile, NumbersMayStandOnLinesOfTheirOwn) {
  EXPECT_EQ(place_of(read(model(link("a", "<pose>\n1 2\r\n\t3 0 0 0\n</pose>"))), "a").t[1], 2);
}

TEST_F(SdfFile, AWorldIsOneRobotOfItsModels) {
  const Robot robot =
      read("<sdf version=\"1.9\"><world name=\"w\"><model name=\"m\"><pose>0 0 1 0 0 0</pose>" +
           link("l", shape("<plane><normal>0 0 2</normal></plane>")) + "</model><model name=\"n\">" +
           link("l") + "</model></world></sdf>");
  EXPECT_EQ(robot.name, "w");
  EXPECT_EQ(names_of(robot), (std::vector<std::string>{"m::l", "m::l c", "n::l"}));
  EXPECT_NE(as_half_space(*robot.links[1].shapes.at(0)), nullptr);
  expect_near(place_of(robot, "m::l c"), Vector3d::Zero(), {0, 0, 1});
}

TEST_F(SdfFile, AMimicFollowsItsLeader) {
  const Robot robot = read(model(
      link("a") + link("b") + link("c") + joint(axis("1 0 0"), "prismatic") +
      "<joint name=\"k\" type=\"prismatic\"><parent>a</parent><child>c</child>" +
      axis("1 0 0",
           "<mimic "
           "joint=\"j\"><multiplier>-2</multiplier><offset>1</offset><reference>3</reference></mimic>") +
      "</joint>"));
  EXPECT_EQ(robot.joints, std::vector<std::string>{"j"});
  EXPECT_EQ(place_of(robot, "c", Eigen::VectorXd::Constant(1, 5)).t[0], -2 * (5 - 3) + 1);
}

TEST_F(SdfFile, WhatIsNotUnderstoodIsNamedWithFileAndLine) {
  const std::string two = link("a") + link("b");
  expect_refusals({
      {"<sdf version=\"1.9\"/>", "m.sdf:1: an SDF file needs one model or one world"},
      {model(""), "m.sdf:1: a robot without a link"},
      {model(link("a") + link("a")), "m.sdf:2: a second model, link, joint or frame 'a'"},
      {model(link("a") + joint("", "fixed")), "m.sdf:2: joint 'j': there is no link 'b'"},
      {model(two + joint("", "screw")), "m.sdf:2: joint 'j' is screw, which is not read"},
      {model(two + joint("")), "m.sdf:2: joint 'j' has no <axis>"},
      {model(two + joint(axis("0 0 0"))), "m.sdf:2: joint 'j' has no axis"},
      {model(link("a", "<pose>1 2 3</pose>")), "m.sdf:2: <pose> has 3 numbers, 6 are expected"},
      {model(link("a", "<pose>nan 0 0 0 0 0</pose>")), "m.sdf:2: <pose>: 'nan' is not a number"},
      {model(link("a", "<pose relative_to=\"b\"/>") + link("b", "<pose relative_to=\"a\"/>")),
       "m.sdf:2: the pose of 'a' is relative to itself"},
      {model(link("a", "<pose relative_to=\"x\"/>")), "m.sdf:2: there is no frame 'x'"},
      {model(link("a", shape("<heightmap/>"))), "m.sdf:2: link 'a': the collision shape <heightmap> is not"},
      {model(link("a", shape("<box/>"))), "m.sdf:2: link 'a': <box> needs <size>"},
      {model(link("a", shape("<sphere/>"))), "m.sdf:2: <sphere> needs <radius>"},
      {model(link("a", shape("<mesh><uri>gone.stl</uri></mesh>"))),
       "m.sdf:2: link 'a': there is no mesh gone.stl"},
      {model("<include><uri>gone</uri></include>"), "m.sdf:2: there is no model gone"},
  });
}

}  // namespace
}  // namespace raygauge::cli::test_sdf_file
