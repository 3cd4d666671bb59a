// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/motion.h"

#include <algorithm>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

std::size_t joints_of(std::span<const Twist> twists_1, std::span<const Twist> twists_2) {
  if (!twists_1.empty() && !twists_2.empty() && twists_1.size() != twists_2.size()) {
    throw DimensionMismatchError("joints: the bodies have " + std::to_string(twists_1.size()) + " and " +
                                 std::to_string(twists_2.size()) + " twists");
  }
  return std::max(twists_1.size(), twists_2.size());
}

Twist sum(std::span<const Twist> twists, std::span<const double> dq) {
  Twist all;
  for (std::size_t j = 0; j < twists.size(); ++j) {
    all.linear = all.linear + twists[j].linear * dq[j];
    all.angular = all.angular + twists[j].angular * dq[j];
  }
  return all;
}

}  // namespace

std::vector<Twist> joint_twists(const std::shared_ptr<const KinematicTree>& tree, std::span<const double> q,
                                int link, const Placement& base, const Placement& origin) {
  JointTrajectory still;
  still.times = {0, 1};
  still.values = Eigen::VectorXd::Map(q.data(), static_cast<Eigen::Index>(q.size())).replicate(1, 2);
  const LinkMotion motion(tree, std::make_shared<const JointTrajectory>(still), base, link);
  std::vector<Twist> twists = motion.joint_twists(0);
  const Eigen::Vector3d arm = motion.at(0).turned(origin.t);
  for (Twist& twist : twists)
    twist.linear = twist.linear + cross(twist.angular, Vector3{arm[0], arm[1], arm[2]});
  return twists;
}

Vector joint_gradient(const PoseGradient& gradient, std::span<const Twist> twists_1,
                      std::span<const Twist> twists_2) {
  const std::size_t joints = joints_of(twists_1, twists_2);
  if (gradient.kind == GradientKind::none) return {};
  Vector slopes = Vector::Zero(static_cast<Eigen::Index>(joints));
  for (std::size_t j = 0; j < joints; ++j) {
    double& slope = slopes[static_cast<Eigen::Index>(j)];
    if (!twists_1.empty()) slope += dot(gradient.body_1, twists_1[j]);
    if (!twists_2.empty()) slope += dot(gradient.body_2, twists_2[j]);
  }
  return slopes;
}

double derivative_along_joints(const PoseGradient& gradient, std::span<const Twist> twists_1,
                               std::span<const Twist> twists_2, std::span<const double> dq) {
  if (dq.size() != joints_of(twists_1, twists_2))
    throw DimensionMismatchError("joints: " + std::to_string(dq.size()) + " rates do not fit the twists");
  return gradient.along(sum(twists_1, dq), sum(twists_2, dq));
}

}  // namespace raygauge
