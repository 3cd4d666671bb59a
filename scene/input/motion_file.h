// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "raygauge/scene/motion.h"

namespace raygauge::cli {

/// Poses over time from a CSV file (see read_number_table) with the columns time, x, y, angle in the plane;
/// time, x, y, z, qw, qx, qy, qz in space. The heading is needed: quaternions are written in two orders.
/// Throws Error, with file and line.
MotionPointer read_pose_file(const std::string& path, int dimension);

/// Joint values over time from a CSV file with a column `time` and one for each of `joints`. `without_value`
/// says of other joints of the robot why a column for them is refused: "mimics 'a'".
std::shared_ptr<const JointTrajectory> read_joint_file(
    const std::string& path, const std::vector<std::string>& joints,
    const std::map<std::string, std::string>& without_value);

}  // namespace raygauge::cli
