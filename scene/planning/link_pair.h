// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/planning/collision_matrix.h"

namespace raygauge {

/// Two bodies of a robot over the whole box of joint values, as collision_matrix() documents it.
LinkVerdict prove_link_pair(const RobotModel& robot, const std::vector<JointRange>& ranges, int a, int b,
                            const CollisionMatrixOptions& options);

}  // namespace raygauge
