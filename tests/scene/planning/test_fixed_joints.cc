// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/fixed_joints.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "scene/planning/robot_chain.h"
#include "tests/scene/planning/random_robots.h"

namespace raygauge::test_fixed_joints {
namespace {

using namespace random_robots;

// Every link is where it is when the joints have these values, whatever the others do.
TEST(FixedJoints, LinksStandWhereTheValuesOfTheJointsPutThem) {
  Random random(3);
  int fixed_some = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const RobotModel model = robot(random);
    const std::vector<double> q = configuration(random, model, 1);
    std::vector<bool> moves;
    for (int i = 0; i < model.joints; ++i) moves.push_back(uniform(random, 0, 1) < 0.5);
    const FixedJoints fixed = fix_joints(model.tree, q, moves);
    std::vector<double> own;
    for (const int joint : fixed.moving) own.push_back(q[static_cast<std::size_t>(joint)]);
    RobotChain whole(model.tree, model.joints, model.base);
    RobotChain reduced(fixed.tree, static_cast<int>(own.size()), model.base);
    std::vector<Frame> expected(model.tree.links.size()), frames(model.tree.links.size());
    whole.follow(q, q, 0, 1);
    reduced.follow(own, own, 0, 1);
    whole.place(0, expected.data());
    reduced.place(0, frames.data());
    if (own.size() < q.size()) ++fixed_some;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const PlacementError error = whole.error(static_cast<int>(i));
      EXPECT_LE((frames[i].t - expected[i].t).norm(), error.place) << trial;
      EXPECT_LE((frames[i].R - expected[i].R).norm(), 2 * error.turn) << trial;
    }
  }
  EXPECT_GT(fixed_some, 100);
}

TEST(FixedJoints, ValuesMustBeOfAllJointsAndFinite) {
  KinematicTree tree;
  TreeLink link;
  link.origin = Placement::identity(3);
  link.kind = JointKind::revolute;
  link.joint = 1;
  tree.links = {link};
  EXPECT_THROW(fix_joints(tree, {0}, {true}), DimensionMismatchError);
  EXPECT_THROW(fix_joints(tree, {0, 0}, {true}), DimensionMismatchError);
  EXPECT_THROW(fix_joints(tree, {0, std::nan("")}, {true, false}), NonFiniteError);
  EXPECT_EQ(fix_joints(tree, {0, 0}, {false, true}).tree.links[0].joint, 0);
  EXPECT_EQ(fix_joints(tree, {0, 0}, {true, false}).tree.links[0].kind, JointKind::fixed);
}

}  // namespace
}  // namespace raygauge::test_fixed_joints
