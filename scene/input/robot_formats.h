// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/input/xml_values.h"
#include "scene/input/robot_file.h"

namespace raygauge::cli {

/// A file of a robot, parsed.
struct RobotSource {
  const std::string& path;
  const RobotMeshes& meshes;
  const XmlFile& file;
};

/// Each reads one format; see docs/meshes.md. They throw what read_robot throws. Another format is another
/// file, declared here, and its line in robot_file.cc.
Robot urdf_robot(const RobotSource& source);
Robot mjcf_robot(const RobotSource& source);
Robot sdf_robot(const RobotSource& source);

}  // namespace raygauge::cli
