// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planning/fixed_joints.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// First the joint's own movement, then the origin.
Placement moved_by(const TreeLink& link, double value) {
  Placement own = Placement::identity(3);
  if (link.kind == JointKind::revolute) own.R = rotation_about(value * link.axis);
  if (link.kind == JointKind::prismatic) own.t = value * link.axis;
  const Placement at = make_placement(link.origin.R, link.origin.t) * own;
  return make_placement(at.R, at.t);
}

}  // namespace

FixedJoints fix_joints(const KinematicTree& tree, const std::vector<double>& values,
                       const std::vector<bool>& moves) {
  int joints = 0;
  for (const TreeLink& link : tree.links) joints = std::max(joints, link.joint + 1);
  if (values.size() != moves.size() || values.size() < static_cast<std::size_t>(joints)) {
    throw DimensionMismatchError("values of " + std::to_string(values.size()) + " joints, and " +
                                 std::to_string(moves.size()) + " that move or not, for " +
                                 std::to_string(joints) + " joints");
  }
  FixedJoints fixed{tree, {}};
  std::vector<int> numbers(values.size(), -1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) throw NonFiniteError("the value of a joint is not finite");
    if (!moves[i]) continue;
    numbers[i] = static_cast<int>(fixed.moving.size());
    fixed.moving.push_back(static_cast<int>(i));
  }
  for (TreeLink& link : fixed.tree.links) {
    if (link.kind == JointKind::fixed) continue;
    if (link.joint < 0) throw InvalidParameterError("robot: there is no joint number -1");
    const auto joint = static_cast<std::size_t>(link.joint);
    if (!moves[joint]) {
      link.origin = moved_by(link, link.scale * values[joint] + link.offset);
      link.kind = JointKind::fixed;
    }
    link.joint = numbers[joint];
  }
  return fixed;
}

}  // namespace raygauge
