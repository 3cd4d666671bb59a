// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/srdf_file.h"

#include <gtest/gtest.h>

#include <string>

#include "raygauge/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_srdf_file {
namespace {

/// base - turn - a - lift - b - fixed - hand, and two fingers on the hand, one of which mimics the other.
constexpr const char* kRobot = R"(<robot name="r">
<link name="base"/><link name="a"/><link name="b"/><link name="hand"/><link name="left"/><link name="right"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="a"/><limit lower="-1" upper="2"/></joint>
<joint name="lift" type="continuous"><parent link="a"/><child link="b"/></joint>
<joint name="mount" type="fixed"><parent link="b"/><child link="hand"/></joint>
<joint name="grip" type="prismatic"><parent link="hand"/><child link="left"/><limit lower="0" upper="0.4"/></joint>
<joint name="follow" type="prismatic"><parent link="hand"/><child link="right"/><limit lower="-0.2" upper="0.1"/>
<mimic joint="grip" multiplier="-0.5" offset="0.05"/></joint>
</robot>)";

enum Link { kBase, kA, kB, kHand, kLeft, kRight };

class SrdfFile : public ::testing::Test {
 protected:
  SrdfFile() {
    testing::write_bytes(folder_.file("r.urdf"), kRobot);
    robot_ = read_robot(folder_.file("r.urdf"), {});
  }

  RobotSemantics read(const std::string& inside) const {
    testing::write_bytes(folder_.file("r.srdf"), "<robot name=\"r\">\n" + inside + "\n</robot>\n");
    return read_srdf(folder_.file("r.srdf"), robot_);
  }

  std::string complaint(const std::string& inside) const {
    try {
      read(inside);
    } catch (const Error& error) {
      return std::string(error.what()).substr(folder_.path().size() + 1);
    }
    return "nothing was thrown";
  }

  testing::TemporaryFolder folder_;
  Robot robot_;
};

using Pairs = std::vector<std::pair<int, int>>;

Pairs disabled(const RobotSemantics& semantics) {
  Pairs pairs;
  for (const DisabledPair& pair : semantics.disabled) pairs.emplace_back(pair.link_a, pair.link_b);
  return pairs;
}

TEST_F(SrdfFile, DisabledPairsAreOfLinksInAnyOrderEachOnce) {
  const RobotSemantics semantics = read(
      "<disable_collisions link1=\"hand\" link2=\"a\" reason=\"Never\"/>"
      "<disable_collisions link1=\"a\" link2=\"hand\" reason=\"Never\"/>"
      "<disable_collisions link1=\"base\" link2=\"a\"/>");
  EXPECT_EQ(disabled(semantics), (Pairs{{kBase, kA}, {kA, kHand}}));
  EXPECT_EQ(semantics.disabled[0].reason, "");
  EXPECT_EQ(semantics.disabled[1].reason, "Never");
}

TEST_F(SrdfFile, ALinkThatIsOffMeetsOnlyWhatIsEnabledAgain) {
  const RobotSemantics semantics = read(
      "<enable_collisions link1=\"left\" link2=\"b\"/><disable_default_collisions link=\"left\"/>"
      "<disable_collisions link1=\"a\" link2=\"b\" reason=\"Adjacent\"/>");
  EXPECT_EQ(disabled(semantics),
            (Pairs{{kBase, kLeft}, {kA, kB}, {kA, kLeft}, {kHand, kLeft}, {kLeft, kRight}}));
  EXPECT_EQ(semantics.disabled[0].reason, "Default");
}

TEST_F(SrdfFile, GroupsAreChainsLinksJointsAndOtherGroups) {
  const RobotSemantics semantics = read(
      "<group name=\"arm\"><chain base_link=\"a\" tip_link=\"hand\"/></group>"
      "<group name=\"fingers\"><link name=\"left\"/><joint name=\"follow\"/></group>"
      "<group name=\"all\"><group name=\"arm\"/><group name=\"fingers\"/></group>"
      "<group_state name=\"up\" group=\"arm\"><joint name=\"lift\" value=\"0.5\"/></group_state>"
      "<end_effector name=\"tool\" group=\"fingers\" parent_link=\"hand\" parent_group=\"arm\"/>");
  const auto group = [&](const char* name) { return semantics.group(name, ""); };
  EXPECT_EQ(robot_.joints, (std::vector<std::string>{"turn", "lift", "grip"}));
  EXPECT_EQ(group("arm").joints, (std::vector<bool>{false, true, false}));
  EXPECT_EQ(group("arm").links, (std::vector<int>{kA, kB, kHand}));
  EXPECT_EQ(group("fingers").joints, (std::vector<bool>{false, false, true}));
  EXPECT_EQ(group("fingers").links, (std::vector<int>{kLeft, kRight}));
  EXPECT_EQ(group("all").joints, (std::vector<bool>{false, true, true}));
  EXPECT_EQ(group("arm").states.at("up"), (std::map<int, double>{{1, 0.5}}));
  ASSERT_EQ(semantics.end_effectors.size(), 1U);
  EXPECT_EQ(semantics.end_effectors[0].parent_group, "arm");
  EXPECT_THROW(group("leg"), UnknownNameError);
}

TEST_F(SrdfFile, WhatTheRobotDoesNotHaveIsNamedOnce) {
  const RobotSemantics semantics = read(
      "<virtual_joint name=\"v\" type=\"floating\" parent_frame=\"w\" child_link=\"base\"/>"
      "<passive_joint name=\"follow\"/>"
      "<disable_collisions link1=\"crate\" link2=\"a\"/><disable_collisions link1=\"b\" link2=\"crate\"/>"
      "<group name=\"g\"><joint name=\"wheel\"/><link name=\"b\"/></group>");
  EXPECT_TRUE(semantics.disabled.empty());
  EXPECT_EQ(semantics.unknown, (std::vector<std::string>{"link 'crate'", "joint 'wheel'"}));
}

TEST_F(SrdfFile, WhatIsNotUnderstoodIsRefusedWithItsLine) {
  EXPECT_EQ(complaint("\n<disable_colisions link1=\"a\" link2=\"b\"/>"),
            "r.srdf:3: <disable_colisions> is not understood");
  EXPECT_EQ(complaint("<disable_collisions link1=\"a\"/>"),
            "r.srdf:2: <disable_collisions> needs the attribute link2");
  EXPECT_EQ(complaint("<disable_collisions link1=\"a\" link2=\"a\"/>"), "r.srdf:2: a pair of one link");
  EXPECT_EQ(complaint("<group name=\"g\"><chain base_link=\"left\" tip_link=\"right\"/></group>"),
            "r.srdf:2: no chain goes from 'left' to 'right'");
  EXPECT_EQ(complaint("<group name=\"g\"><group name=\"h\"/></group>"),
            "r.srdf:2: there is no group 'h' before this one");
  EXPECT_EQ(complaint("<group_state name=\"s\" group=\"h\"/>"), "r.srdf:2: there is no group 'h'");
  EXPECT_EQ(complaint("<group name=\"g\"/><group_state name=\"s\" group=\"g\"><joint name=\"lift\" "
                      "value=\"high\"/></group_state>"),
            "r.srdf:2: value must be a finite number, got 'high'");
  EXPECT_EQ(complaint("<link name=\"a\"/>"), "r.srdf:2: <link> is of a URDF file");
}

TEST_F(SrdfFile, LimitsOfAJointAreAlsoThoseOfItsMimics) {
  const std::vector<JointLimits> limits = limits_of(robot_);
  ASSERT_EQ(limits.size(), 3U);
  EXPECT_EQ(limits[0].lower, -1);
  EXPECT_EQ(limits[0].upper, 2);
  EXPECT_TRUE(limits[1].turns);
  EXPECT_EQ(limits[1].upper, std::numeric_limits<double>::infinity());
  EXPECT_EQ(limits[2].lower, 0);  // -0.5 grip + 0.05 <= 0.1 from -0.1 on
  EXPECT_EQ(limits[2].upper, 0.4);
  EXPECT_FALSE(limits[2].turns);
}

}  // namespace
}  // namespace raygauge::cli::test_srdf_file
