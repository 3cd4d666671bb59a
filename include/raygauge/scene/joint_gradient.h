// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "raygauge/queries/gradient.h"
#include "raygauge/scene/joint_motion.h"

namespace raygauge {

// Derivatives along the joints of a robot: those by pose (PoseGradient) times the twists of the bodies.

/// The twists of a body on a link, one for each joint: how it moves while the value of that joint rises by 1
/// per second and the others stay. With o the body's origin, a the axis of a joint in the world and p a point
/// on it,
///
///     revolute: (a × (o - p), a),      prismatic: (a, 0),
///
/// times `scale` of a joint that mimics another; 0 of joints that do not carry the link. `base`: where the
/// robot stands; `origin`: where the frame of the body is on the link. Throws what LinkMotion throws.
std::vector<Twist> joint_twists(const std::shared_ptr<const KinematicTree>& tree, std::span<const double> q,
                                int link, const Placement& base = Placement::identity(3),
                                const Placement& origin = Placement::identity(3));

/// d/dq: body_1 · twists_1[j] + body_2 · twists_2[j] for each joint j, where the poses of the answer are
/// those at q. A body that is not on the robot has no twists: an empty span. Where the gradient is not
/// unique, one of them; of GradientKind::none nothing. Throws DimensionMismatchError for different numbers of
/// twists.
Vector joint_gradient(const PoseGradient& gradient, std::span<const Twist> twists_1,
                      std::span<const Twist> twists_2);

/// PoseGradient::along() while the joints move at the rates dq: also where the gradient is not unique. Throws
/// DimensionMismatchError unless there is a rate for each twist.
double derivative_along_joints(const PoseGradient& gradient, std::span<const Twist> twists_1,
                               std::span<const Twist> twists_2, std::span<const double> dq);

}  // namespace raygauge
