// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/collision_matrix.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "scene/planning/joint_box.h"
#include "tests/engine/meshes/mesh_shapes.h"
#include "tests/scene/planning/random_robots.h"

namespace raygauge::test_collision_matrix {
namespace {

using namespace random_robots;

std::vector<JointRange> ranges(int joints, double most) {
  return std::vector<JointRange>(static_cast<std::size_t>(joints), JointRange{-most, most});
}

// Rods that share a joint meet; with both joints at the angle q rods 0 and 2 are (1 + 2 cos(q)) apart at the
// tips, and meet as soon as the arm closes to a triangle, beyond 2 pi / 3.
TEST(CollisionMatrix, RodsMeetAtTheAngleOfTheClosedForm) {
  const double radius = 0.01;
  for (const bool closes : {false, true}) {
    const double most = closes ? 2.2 : 1.9;
    const auto verdicts = collision_matrix(planar_arm(3, radius), ranges(3, most));
    ASSERT_EQ(verdicts.size(), 3U);
    EXPECT_EQ(verdicts[0].contact, LinkContact::always);
    EXPECT_EQ(verdicts[2].contact, LinkContact::always);
    EXPECT_EQ(verdicts[1].joints, 2);
    EXPECT_EQ(verdicts[1].contact, closes ? LinkContact::sometimes : LinkContact::never);
    EXPECT_EQ(verdicts[1].contact_at.empty(), !closes);
    if (closes) continue;
    EXPECT_EQ(verdicts[1].undecided, 0);
    EXPECT_GT(verdicts[1].least, 0);
    EXPECT_LT(verdicts[1].least, 1 + 2 * std::cos(most) - 2 * radius + 1e-9);
  }
}

// The same of rods that are meshes.
TEST(CollisionMatrix, MeshesMeetWhereConvexBodiesOfTheirShapeDo) {
  const double radius = 0.05;
  const testing::MeshShape rod = testing::box_shape({0, -radius, -radius}, {1, radius, radius}, 2);
  for (const MeshKind kind : {MeshKind::surface, MeshKind::solid}) {
    for (const double most : {2.2, 1.9}) {
      RobotModel robot = planar_arm(3, radius);
      robot.bodies[0].parts = {std::make_shared<MeshObject>(Mesh(rod.vertices, rod.triangles, kind))};
      robot.bodies[2].parts = robot.bodies[0].parts;
      const auto verdicts = collision_matrix(robot, ranges(3, most));
      ASSERT_EQ(verdicts.size(), 3U);
      EXPECT_EQ(verdicts[0].contact, LinkContact::always);
      EXPECT_EQ(verdicts[1].contact, most > 2 ? LinkContact::sometimes : LinkContact::never);
      EXPECT_EQ(verdicts[2].contact, LinkContact::always);
    }
  }
}

RobotModel two_links(JointKind kind, const Eigen::Vector3d& axis, const Eigen::Vector3d& origin) {
  RobotModel robot;
  robot.joints = 1;
  robot.tree.links.resize(2);
  for (TreeLink& link : robot.tree.links) link.origin = Placement::identity(3);
  robot.tree.links[1].parent = 0;
  robot.tree.links[1].kind = kind;
  robot.tree.links[1].axis = axis;
  robot.tree.links[1].joint = 0;
  robot.tree.links[1].origin.t = vector3(origin[0], origin[1], origin[2]);
  return robot;
}

std::vector<std::shared_ptr<const ConvexSet>> box(double x, double y, double z) {
  return {std::make_shared<Box>(vector3(-x, -y, -z), vector3(x, y, z))};
}

// A box on the top of another one, face on face, that turns about an axis through both, and with a gap.
TEST(CollisionMatrix, LinksThatOnlyTouchOnTheAxisOfTheirJointAlwaysMeet) {
  for (const double gap : {0.0, 1e-3}) {
    RobotModel robot = two_links(JointKind::revolute, {0, 0, 1}, {0.2, 0.1, 2 + gap});
    robot.bodies = {{"below", 0, box(1, 1, 1)}, {"above", 1, box(0.5, 0.7, 1)}};
    const std::vector<LinkVerdict> verdicts = collision_matrix(robot, ranges(1, 3));
    EXPECT_EQ(verdicts[0].contact, gap > 0 ? LinkContact::never : LinkContact::always);
    EXPECT_EQ(verdicts[0].undecided, 0);
  }
}

// The same box off the axis: the axis passes it by, and no other proof is known.
TEST(CollisionMatrix, LinksThatTouchOffTheAxisOfTheirJointStayUndecided) {
  CollisionMatrixOptions options;
  options.max_boxes = 100;
  RobotModel robot = two_links(JointKind::revolute, {0, 0, 1}, {0, 0, 2});
  robot.bodies = {{"below", 0, box(2, 2, 1)}, {"above", 1, box(0.2, 0.2, 1)}};
  robot.bodies[1].origin.t = vector3(1, 0, 0);
  EXPECT_EQ(collision_matrix(robot, ranges(1, 1), options)[0].contact, LinkContact::undecided);
}

// A box that slides on another one, until it has left it.
TEST(CollisionMatrix, LinksThatSlideOnEachOtherMeetAsFarAsTheyReach) {
  for (const double most : {1.4, 1.6}) {
    RobotModel robot = two_links(JointKind::prismatic, {0, 1, 0}, {0, 0, 2});
    robot.bodies = {{"below", 0, box(1, 1, 1)}, {"above", 1, box(0.5, 0.5, 1)}};
    const std::vector<LinkVerdict> verdicts = collision_matrix(robot, ranges(1, most));
    EXPECT_EQ(verdicts[0].contact, most < 1.5 ? LinkContact::always : LinkContact::sometimes);
  }
}

TEST(CollisionMatrix, WhatIsKnownIsNotProvenAgain) {
  const RobotModel arm = planar_arm(4, 0.01);
  CollisionMatrixOptions options;
  options.max_boxes = 2000;
  CollisionMatrixHooks hooks;
  std::vector<LinkVerdict> told;
  hooks.proven = [&](const LinkVerdict& verdict) { told.push_back(verdict); };
  const auto whole = collision_matrix(arm, ranges(4, 1.5), options, hooks);
  EXPECT_EQ(told.size(), whole.size());
  hooks.known = {whole[1], whole[4]};
  hooks.known[0].boxes = -1;  // which no proof gives
  told.clear();
  const auto again = collision_matrix(arm, ranges(4, 1.5), options, hooks);
  EXPECT_EQ(told.size(), whole.size() - 2);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    EXPECT_EQ(again[i].contact, whole[i].contact);
    EXPECT_EQ(again[i].boxes, i == 1 ? -1 : whole[i].boxes);
  }
}

TEST(CollisionMatrix, WhatIsNotProvenWithinTheBoxesIsSaid) {
  CollisionMatrixOptions options;
  options.max_boxes = 20;
  const auto verdicts = collision_matrix(planar_arm(3, 0.01), ranges(3, 2.05), options);
  EXPECT_EQ(verdicts[1].contact, LinkContact::undecided);
  EXPECT_GT(verdicts[1].undecided, 0);
  EXPECT_LE(verdicts[1].undecided, 1);
}

// A ball that is in contact nowhere but around one value of a joint.
TEST(CollisionMatrix, ARareContactIsFound) {
  RobotModel robot = planar_arm(3, 0.01);
  RobotBody tip;
  tip.name = "tip";
  tip.link = 2;
  tip.origin.t = vector3(1.5, 0, 0);
  tip.parts = {std::make_shared<Ball>(Vector::Zero(3), 1e-3)};
  RobotBody post = tip;
  post.link = 0;
  post.origin.t = vector3(-0.6, 1.5, 0);
  robot.bodies = {post, tip};
  const auto verdicts = collision_matrix(robot, ranges(3, 2));
  ASSERT_EQ(verdicts[0].contact, LinkContact::sometimes);
  EdgeChecker checker(robot, {});
  EXPECT_EQ(checker.configuration(verdicts[0].contact_at).outcome, EdgeOutcome::contact);
  EXPECT_EQ(checker.configuration(verdicts[0].free_at).outcome, EdgeOutcome::free);
}

// Dense sampling contradicts no verdict, and every witness is one.
TEST(CollisionMatrix, SamplesOfRandomRobotsContradictNoVerdict) {
  Random random(11);
  CollisionMatrixOptions options;
  options.max_boxes = 1000;
  options.threads = 2;
  int counts[4] = {};
  for (int trial = 0; trial < 12; ++trial) {
    RobotModel model = robot(random);
    model.ignored.clear();
    std::vector<JointRange> box;
    for (int j = 0; j < model.joints; ++j) {
      const double lower = uniform(random, -2, 2);
      box.push_back({lower, lower + uniform(random, 0, 1.5)});
    }
    for (const LinkVerdict& verdict : collision_matrix(model, box, options)) {
      ++counts[static_cast<int>(verdict.contact)];
      RobotModel two = model;
      two.bodies = {model.bodies[static_cast<std::size_t>(verdict.body_a)],
                    model.bodies[static_cast<std::size_t>(verdict.body_b)]};
      EdgeChecker checker(two, {});
      const auto outcome = [&](const std::vector<double>& q) { return checker.configuration(q).outcome; };
      if (verdict.contact == LinkContact::sometimes) {
        EXPECT_EQ(outcome(verdict.contact_at), EdgeOutcome::contact) << trial;
        EXPECT_EQ(outcome(verdict.free_at), EdgeOutcome::free) << trial;
      }
      for (int k = 0; k < 20; ++k) {
        std::vector<double> q;
        for (const JointRange& range : box) q.push_back(uniform(random, range.lower, range.upper));
        if (verdict.contact == LinkContact::never) {
          EXPECT_EQ(outcome(q), EdgeOutcome::free) << trial;
        } else if (verdict.contact == LinkContact::always) {
          EXPECT_EQ(outcome(q), EdgeOutcome::contact) << trial;
        }
      }
    }
  }
  for (int kind = 0; kind < 3; ++kind) EXPECT_GT(counts[kind], 10) << kind;
}

// No point of two bodies moves farther, seen from anywhere between them, than is said.
TEST(JointsBetween, BoundsTheChangeOfEveryDistanceOfTwoPoints) {
  Random random(5);
  int tried = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const RobotModel model = robot(random);
    if (model.bodies.size() < 2) continue;
    RobotChain chain(model.tree, model.joints, model.base);
    std::vector<EdgeBody> bodies = edge_bodies(model, {}, chain);
    const EdgeBody &a = bodies.front(), &b = bodies.back();
    JointsBetween between(model.tree, chain, a.link, b.link);
    const auto links = static_cast<std::size_t>(chain.links());
    std::vector<Frame> middle(links), there(links);
    const std::vector<double> q = configuration(random, model, 1);
    std::vector<double> half, other = q;
    for (std::size_t j = 0; j < q.size(); ++j) {
      half.push_back(uniform(random, 0, trial % 2 == 0 ? 0.1 : 3.5));
      other[j] += uniform(random, -1, 1) * half[j];
    }
    chain.follow(q, q, 0, 1);
    chain.place(0, middle.data());
    chain.follow(other, other, 0, 1);
    chain.place(0, there.data());
    between.stand(middle.data(), a, b);
    const double motion = between.motion(half);
    const auto vertex = [&](const EdgeBody& body) {
      return Eigen::Vector3d(body.body.parts[0].set->support_mapping(uniform_vector(random, 3, 1.0)));
    };
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector3d p = vertex(a), r = vertex(b);
      const auto distance = [&](const std::vector<Frame>& frames) {
        const Frame &at = frames[static_cast<std::size_t>(a.link)],
                    &to = frames[static_cast<std::size_t>(b.link)];
        return (at.R * p + at.t - to.R * r - to.t).norm();
      };
      EXPECT_LE(std::fabs(distance(there) - distance(middle)), motion + 1e-12) << trial;
      ++tried;
    }
  }
  EXPECT_GT(tried, 1000);
}

TEST(CollisionMatrix, RangesAreCheckedAndThreadsChangeNothing) {
  const RobotModel arm = planar_arm(3, 0.01);
  EXPECT_THROW(collision_matrix(arm, ranges(2, 1)), InvalidParameterError);
  EXPECT_THROW(collision_matrix(arm, {{0, 1}, {1, 0}, {0, 1}}), InvalidParameterError);
  EXPECT_THROW(collision_matrix(arm, {{0, 1}, {0, std::numeric_limits<double>::infinity()}, {0, 1}}),
               InvalidParameterError);
  CollisionMatrixOptions two;
  two.threads = 2;
  const auto one = collision_matrix(arm, ranges(3, 1.9)), other = collision_matrix(arm, ranges(3, 1.9), two);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].boxes, other[i].boxes);
    EXPECT_EQ(one[i].least, other[i].least);
  }
}

}  // namespace
}  // namespace raygauge::test_collision_matrix
