// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "raygauge/scene/edge_checker.h"
#include "tests/scene/random_scenes.h"

namespace raygauge::random_robots {

using namespace random_scenes;

inline SmallVector vector3(double x, double y, double z) {
  SmallVector v(3);
  v << x, y, z;
  return v;
}

/// Rods of length 1 and this radius that turn in the plane, each on the end of the one before it.
inline RobotModel planar_arm(int rods, double radius) {
  RobotModel robot;
  robot.joints = rods;
  for (int i = 0; i < rods; ++i) {
    TreeLink link;
    link.parent = i - 1;
    link.kind = JointKind::revolute;
    link.axis = Eigen::Vector3d::UnitZ();
    link.joint = i;
    link.origin = Placement::identity(3);
    if (i > 0) link.origin.t = vector3(1, 0, 0);
    robot.tree.links.push_back(link);
    RobotBody body;
    body.name = "rod " + std::to_string(i);
    body.link = i;
    body.parts = {std::make_shared<Capsule>(vector3(0, 0, 0), vector3(1, 0, 0), radius)};
    robot.bodies.push_back(body);
  }
  return robot;
}

/// A tree of 1 to 14 links whose joints are of all kinds, some of them followed by others, with a small body
/// on most links.
inline RobotModel robot(Random& random) {
  RobotModel robot;
  const int links = 1 + static_cast<int>(random() % 14);
  robot.base = placement(random, 3, 0.3);
  for (int i = 0; i < links; ++i) {
    TreeLink link;
    link.parent =
        i == 0 || random() % 8 == 0 ? -1 + static_cast<int>(random() % static_cast<unsigned>(i + 1)) : i - 1;
    link.origin = placement(random, 3, 1.5);
    link.kind = static_cast<JointKind>(random() % 4 == 0 ? random() % 3 : 1);
    link.axis = Eigen::Vector3d(uniform_vector(random, 3, 1.0)).normalized();
    if (link.kind != JointKind::fixed) {
      const bool follows = robot.joints > 0 && random() % 5 == 0;
      link.joint =
          follows ? static_cast<int>(random() % static_cast<unsigned>(robot.joints)) : robot.joints++;
      link.scale = follows ? uniform(random, -1.5, 1.5) : 1;
      link.offset = follows ? uniform(random, -0.3, 0.3) : 0;
    }
    robot.tree.links.push_back(link);
    if (random() % 4 == 0) continue;
    RobotBody body;
    body.name = "link " + std::to_string(i);
    body.link = i;
    body.parts = {shape(random, 3, static_cast<int>(random() % kShapes))};
    if (random() % 5 == 0) body.parts.push_back(shape(random, 3, 0));
    if (random() % 4 == 0) body.origin = placement(random, 3, 0.2);
    robot.bodies.push_back(body);
  }
  robot.ignored = joined_bodies(robot);
  const auto count = static_cast<int>(robot.bodies.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {  // many of them overlap wherever the joints are
      if (random() % 3 != 0) robot.ignored.emplace_back(a, b);
    }
  }
  return robot;
}

inline std::vector<Body> obstacles(Random& random, int count, double size) {
  std::vector<Body> bodies;
  for (int i = 0; i < count; ++i) {
    bodies.push_back(make_body("obstacle " + std::to_string(i),
                               {shape(random, 3, static_cast<int>(random() % kShapes))},
                               motion(random, 3, size)));
  }
  return bodies;
}

inline std::vector<double> configuration(Random& random, const RobotModel& robot, double size) {
  std::vector<double> q;
  for (int i = 0; i < robot.joints; ++i) q.push_back(uniform(random, -size, size));
  return q;
}

inline JointTrajectory line(const std::vector<double>& q0, const std::vector<double>& q1) {
  JointTrajectory trajectory;
  trajectory.times = {0, 1};
  trajectory.values.resize(static_cast<Eigen::Index>(q0.size()), 2);
  for (std::size_t i = 0; i < q0.size(); ++i) {
    trajectory.values(static_cast<Eigen::Index>(i), 0) = q0[i];
    trajectory.values(static_cast<Eigen::Index>(i), 1) = q1[i];
  }
  return trajectory;
}

/// All bodies, in the numbers of an EdgeResult, with motions of their own: by LinkMotion.
inline std::vector<Body> moving_bodies(const RobotModel& robot, const std::vector<Body>& obstacles,
                                       const JointTrajectory& trajectory) {
  auto tree = std::make_shared<KinematicTree>(robot.tree);
  std::vector<int> links;
  for (const RobotBody& body : robot.bodies) {
    TreeLink own;
    own.parent = body.link;
    own.origin = body.origin;
    tree->links.push_back(own);
    links.push_back(static_cast<int>(tree->links.size()) - 1);
  }
  const auto shared = std::make_shared<const JointTrajectory>(trajectory);
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < robot.bodies.size(); ++i) {
    bodies.push_back(make_body(robot.bodies[i].name, robot.bodies[i].parts,
                               LinkMotion::make(tree, shared, robot.base, links[i])));
  }
  bodies.insert(bodies.end(), obstacles.begin(), obstacles.end());
  return bodies;
}

inline bool is_ignored(const RobotModel& robot, int a, int b) {
  for (const auto& [one, other] : robot.ignored) {
    if ((one == a && other == b) || (one == b && other == a)) return true;
  }
  return a >= static_cast<int>(robot.bodies.size()) && b >= static_cast<int>(robot.bodies.size());
}

}  // namespace raygauge::random_robots
