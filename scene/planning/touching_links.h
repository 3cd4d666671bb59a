// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/planning/collision_matrix.h"

namespace raygauge {

/// Whether two bodies, the only ones of the robot, are proven to be within `contact` of each other for all
/// values of the joints, although they may only touch. Two cases are proven:
///
///   - No joint between the two turns. The distance of two convex parts that are shifted against each other
///     is a convex function of the joint values, and so greatest at a corner of their box.
///   - One joint, which turns, is between the two. Points of its axis stand still as seen from both bodies;
///     their distances from both are an upper bound of the distance of the bodies.
bool touch_everywhere(const RobotModel& robot, const std::vector<JointRange>& ranges, double contact);

}  // namespace raygauge
