// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "raygauge/scene/motion.h"

namespace raygauge {

/// A robot some of whose joints stand still.
struct FixedJoints {
  KinematicTree tree;       ///< in which they are fixed; a joint is a number in `moving`
  std::vector<int> moving;  ///< the other joints, by their numbers in the robot
};

/// The tree with the joints that do not move fixed at these values, one for each joint of the tree. Their
/// frames are rounded once more, within what the bounds of a link allow for. Throws DimensionMismatchError
/// unless there is an entry for each joint in both, and NonFiniteError for a value.
FixedJoints fix_joints(const KinematicTree& tree, const std::vector<double>& values,
                       const std::vector<bool>& moves);

}  // namespace raygauge
