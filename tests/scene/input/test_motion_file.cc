// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/motion_file.h"

#include <gtest/gtest.h>

#include <string>

#include "raygauge/exceptions.h"
#include "tests/results/complaint.h"
#include "tests/results/support.h"

namespace raygauge::cli::test_motion_file {
namespace {

class MotionFile : public ::testing::Test {
 protected:
  MotionPointer poses(const std::string& text, int n = 3) const {
    testing::write_bytes(folder_.file("p.csv"), text);
    return read_pose_file(folder_.file("p.csv"), n);
  }

  std::shared_ptr<const JointTrajectory> joints(const std::string& text) const {
    testing::write_bytes(folder_.file("p.csv"), text);
    return read_joint_file(folder_.file("p.csv"), {"lift", "joint 2"}, {{"grip", "mimics 'lift'"}});
  }

  template <class Call>
  std::string complaint(const Call& call) const {
    return testing::complaint_of(folder_, call);
  }

  std::string of_poses(const std::string& text, int n = 3) const {
    return complaint([&] { poses(text, n); });
  }
  std::string of_joints(const std::string& text) const {
    return complaint([&] { joints(text); });
  }

  testing::TemporaryFolder folder_;
};

TEST_F(MotionFile, ColumnsAreKnownByTheirNamesInAnyOrderAndSpelling) {
  for (const char* text : {
           "time,x,y,z,qw,qx,qy,qz\n0,1,2,3,0,0,0,1\n1,1,2,3,0,0,0,1\n",
           "time,x,y,z,qx,qy,qz,qw\n0,1,2,3,0,0,1,0\n1,1,2,3,0,0,1,0\n",
           "qz,qw,z,y,x,time,qx,qy\n1,0,3,2,1,0,0,0\n1,0,3,2,1,1,0,0\n",
           "\xEF\xBB\xBF\"time\",\"x\",\"y\",\"z\",\"qw\",\"qx\",\"qy\",\"qz\"\r\n0,1,2,3,0,0,0,1\r\n1,1,2,3,"
           "0,0,0,1\r\n",
           "# poses of a robot, and a \"quote\n#time,x,y,z,qw,qx,qy,qz\n# what time is "
           "it\n\n0,1,2,3,0,0,0,1\n1,1,2,3,0,0,0,1\n",
           "# time x y z qw qx qy qz\n0 1 2 3 0 0 0 1\n1 1 2 3 0 0 0 1\n",
           " time ; x ; y;z;qw;qx;qy;qz\n0;1;2;3;0;0;0;1\n1;1;2;3;0;0;0;1\n",
           "time\tx\ty\tz\tqw\tqx\tqy\tqz\n0\t1\t2\t3\t0\t0\t0\t1\n1\t1\t2\t3\t0\t0\t0\t1\n",
       }) {
    MotionPointer motion;
    ASSERT_NO_THROW(motion = poses(text)) << text;
    const Placement at = motion->at(0);
    EXPECT_EQ(Eigen::Vector3d(at.t), Eigen::Vector3d(1, 2, 3)) << text;
    EXPECT_EQ(at.R(0, 0), -1) << text;
    EXPECT_EQ(at.R(2, 2), 1) << text;
  }
}

TEST_F(MotionFile, AFileOfPosesWithoutAHeadingIsRefusedWithBothOrders) {
  EXPECT_EQ(
      of_poses("0,1,2,3,1,0,0,0\n1,1,2,3,1,0,0,0\n"),
      "p.csv: no line names the columns; the first one must be time,x,y,z,qw,qx,qy,qz or "
      "time,x,y,z,qx,qy,qz,qw, as the numbers are ordered: w is first in some files and last in others");
  EXPECT_EQ(of_poses("# my time\n0,1,2,0\n1,1,2,0\n", 2),
            "p.csv: no line names the columns; the first one must be time,x,y,angle");
}

TEST_F(MotionFile, WhatIsWrongIsNamedWithFileAndLine) {
  const std::string heading = "# a path\ntime,x,y,angle\n";
  EXPECT_EQ(of_poses(heading + "0,0,0,0\n\n1,0,0,0\n0.5,0,0,0\n", 2),
            "p.csv:6: times must rise, but 0.5 comes after 1");
  EXPECT_EQ(of_poses(heading + "0,0,0,0\n0,0,0,0\n", 2), "p.csv:4: times must rise, but 0 comes after 0");
  EXPECT_EQ(of_poses("time,x,y\n0,0,0\n1,0,0\n", 2), "p.csv:1: there is no column 'angle'");
  EXPECT_EQ(of_poses("time,x,y,angle,w\n0,0,0,0,0\n1,0,0,0,0\n", 2),
            "p.csv:1: unknown column 'w'; did you mean 'x'? (known: time x y angle)");
  EXPECT_EQ(of_poses("time,x,x,angle\n0,0,0,0\n1,0,0,0\n", 2), "p.csv:1: the column 'x' appears twice");
  EXPECT_EQ(of_poses("time,x,,angle\n0,0,0,0\n1,0,0,0\n", 2), "p.csv:1: column 3 has no name");
  EXPECT_EQ(of_poses("time,x,y,angle\n0,0,0\n1,0,0\n", 2), "p.csv:1: 4 names of columns, but 3 columns");
  EXPECT_EQ(of_poses("\"time,x,y,angle\n0,0,0,0\n", 2), "p.csv:1: a quote that opens here is never closed");
  EXPECT_EQ(of_poses("time,x,y,angle\n0,0,zero,0\n", 2), "p.csv:2:5: 'zero' is not a number");
  EXPECT_EQ(of_poses("time,x,y,angle\none,0,0,0\n", 2),
            "p.csv:2:1: 'one' is not a number (a heading must start with '#')")
      << "no option is named that the command lacks";
  EXPECT_EQ(of_poses("time,x,y,angle\n0,0,0,0\n", 2),
            "p.csv: motion: keyframes need two times at least, and a pose for each");
  EXPECT_EQ(of_poses("time,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0,2,0,0,0\n"),
            "p.csv:3: the quaternion is not a rotation: its length is 2.000000, not 1");
}

TEST_F(MotionFile, JointsHaveNamesWithBlanksAndMimicsTakeNoValues) {
  EXPECT_EQ(joints("joint 2,time,lift\n5,0,1\n6,1,2\n")->values, (Eigen::MatrixXd{{1, 2}, {5, 6}}));
  EXPECT_EQ(joints("\"joint 2\" time lift\n5 0 1\n6 1 2\n")->values, (Eigen::MatrixXd{{1, 2}, {5, 6}}));
  EXPECT_EQ(of_joints("time,lift,joint 2,grip\n0,1,2,3\n1,1,2,3\n"),
            "p.csv:1: joint 'grip' mimics 'lift' and takes no values; leave its column out");
  EXPECT_EQ(of_joints("time,lift,joint 3\n0,1,2\n1,1,2\n"),
            "p.csv:1: unknown joint 'joint 3'; did you mean 'joint 2'? (known: lift joint 2)");
  EXPECT_EQ(of_joints("time,lift\n0,1\n1,1\n"), "p.csv:1: there is no column 'joint 2'");
  EXPECT_EQ(of_joints("0,1,2\n1,1,2\n"),
            "p.csv: no line names the columns; the first one must name time and the joints");
}

}  // namespace
}  // namespace raygauge::cli::test_motion_file
