// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "raygauge/scene/edge_checker.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/capsule.h"

namespace raygauge::planar_arm {

/// Two rods of length 1 that turn in the plane, and a ball in the way of the outer one when both point at it.
inline RobotModel robot() {
  RobotModel arm;
  arm.joints = 2;
  for (int i = 0; i < 2; ++i) {
    TreeLink link;
    link.parent = i - 1;
    link.origin = Placement::identity(3);
    link.origin.t[0] = i;
    link.kind = JointKind::revolute;
    link.axis = Eigen::Vector3d::UnitZ();
    link.joint = i;
    arm.tree.links.push_back(link);
    const auto rod = std::make_shared<Capsule>(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), 0.05);
    arm.bodies.push_back({i == 0 ? "inner" : "outer", i, {rod}});
  }
  arm.ignored = joined_bodies(arm);
  return arm;
}

inline std::vector<Body> ball() {
  Placement where = Placement::identity(3);
  where.t[0] = 1.6;
  return {make_body("ball", {std::make_shared<Ball>(Vector::Zero(3), 0.3)},
                    std::make_shared<StaticMotion>(where))};
}

}  // namespace raygauge::planar_arm
