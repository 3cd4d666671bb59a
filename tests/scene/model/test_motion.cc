// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/motion.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::test_motion {
namespace {

using namespace random_scenes;

// No point within the reach moves farther along any direction than the bound times the time says, and the
// velocity at an inner moment, by differences, is within the bound.
TEST(Motion, BoundsHoldForEveryPointDirectionAndInterval) {
  Random random(1);
  for (int trial = 0; trial < 20000; ++trial) {
    const int n = 2 + trial % 2;
    const MotionPointer moving = motion(random, n, 2.0);
    double from = uniform(random, 0, 1);
    double to = std::min({1.0, moving->next_break(from), from + uniform(random, 1e-4, 1)});
    const double reach = uniform(random, 0.1, 2);
    SmallVector p = uniform_vector(random, n, 1.0);
    p *= reach / std::max(reach, p.norm());
    const SmallVector u = uniform_vector(random, n, 1.0);
    const MotionBound bound = moving->bound(from, to);
    const Placement first = moving->at(from);
    const Placement last = moving->at(to);
    const SmallVector way = (last.R * p + last.t) - (first.R * p + first.t);
    const double rounding = 1e-12;
    EXPECT_LE(way.dot(u), bound.speed_along(u, reach) * (to - from) + rounding);
    EXPECT_LE(way.norm(), bound.speed(reach) * (to - from) + rounding);
  }
}

/// A chain of five links with joints of every kind along a random trajectory over [0, 1].
MotionPointer robot_link(Random& random) {
  auto tree = std::make_shared<KinematicTree>();
  auto trajectory = std::make_shared<JointTrajectory>();
  for (int i = 0; i < 5; ++i) {
    TreeLink link;
    link.parent = i - 1;
    link.origin = placement(random, 3, 0.5);
    link.kind = static_cast<JointKind>(random() % 3);
    link.axis = Eigen::Vector3d(uniform_vector(random, 3, 1.0)).normalized();
    link.joint = i / 2;  // some share a joint, as mimics do
    link.scale = uniform(random, -2, 2);
    link.offset = uniform(random, -1, 1);
    tree->links.push_back(link);
  }
  trajectory->times = {0, 0.3, 1};
  trajectory->values = 2 * Eigen::MatrixXd::Random(3, 3);
  return std::make_shared<LinkMotion>(tree, trajectory, placement(random, 3, 1.0), 4);
}

// The same for links of robots, over long and short intervals.
TEST(Motion, BoundsHoldForLinksOfRobots) {
  Random random(3);
  for (int trial = 0; trial < 20000; ++trial) {
    const MotionPointer moving = robot_link(random);
    const double from = uniform(random, 0, 1);
    const double to = std::min(moving->next_break(from), from + std::pow(10.0, uniform(random, -5, 0)));
    const double reach = uniform(random, 0.1, 2);
    SmallVector p = uniform_vector(random, 3, 1.0);
    p *= reach / std::max(reach, p.norm());
    const SmallVector u = uniform_vector(random, 3, 1.0);
    const MotionBound bound = moving->bound(from, to);
    const Placement first = moving->at(from);
    const Placement last = moving->at(to);
    const SmallVector way = (last.R * p + last.t) - (first.R * p + first.t);
    const double rounding = 1e-12;
    EXPECT_LE(way.dot(u), bound.speed_along(u, reach) * (to - from) + rounding);
    EXPECT_LE(way.norm(), bound.speed(reach) * (to - from) + rounding);
  }
}

TEST(Motion, KeyframesAreMetAndTheShorterWayIsTurned) {
  const Placement first = Placement::identity(3);
  Placement last = first;
  last.R = rotation_about({0, 0, 3 * EIGEN_PI / 2});
  last.t << 1, 2, 3;
  const KeyframeMotion moving({0, 2}, {first, last});
  EXPECT_EQ(moving.at(0).t, first.t);
  EXPECT_EQ(moving.at(2).R, last.R);
  EXPECT_TRUE(moving.at(1).R.isApprox(rotation_about({0, 0, -EIGEN_PI / 4}), 1e-14));
  EXPECT_TRUE(moving.at(1).t.isApprox(last.t / 2, 1e-14));
  EXPECT_THROW(moving.at(2.5), InvalidParameterError);
}

TEST(Motion, RefusesWhatIsNoMotion) {
  const Placement here = Placement::identity(3);
  Placement nowhere = here;
  nowhere.t[0] = std::nan("");
  EXPECT_THROW(KeyframeMotion({0}, {here}), InvalidParameterError);
  EXPECT_THROW(KeyframeMotion({1, 1}, {here, here}), InvalidParameterError);
  EXPECT_THROW(KeyframeMotion({0, 1}, {here, nowhere}), NonFiniteError);
  EXPECT_THROW(KeyframeMotion({0, 1}, {here, Placement::identity(2)}), DimensionMismatchError);
  EXPECT_THROW(make_placement(2 * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()),
               InvalidParameterError);
  EXPECT_THROW(make_placement(-Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()), InvalidParameterError);
}

TEST(Motion, BoundingBallsHoldTheSet) {
  Random random(2);
  for (int trial = 0; trial < 2000; ++trial) {
    const int n = 2 + trial % 2;
    const SetPointer set = shape(random, n, trial % kShapes);
    const BoundingBall ball = bounding_ball(*set);
    for (int i = 0; i < 20; ++i) {
      const Vector point = set->support_mapping(uniform_vector(random, n, 1.0));
      EXPECT_LE((point - ball.center).norm(), ball.radius);
    }
  }
}

}  // namespace
}  // namespace raygauge::test_motion
