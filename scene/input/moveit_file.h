// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "raygauge/scene/scene.h"

namespace raygauge::cli {

/// A planning scene of MoveIt: obstacles that stand, and pairs of links that may touch.
struct MoveItScene {
  std::vector<Body> obstacles;                               ///< one for each collision object
  std::vector<std::pair<std::string, std::string>> allowed;  ///< of the collision matrix
};

/// A motion plan request of MoveIt: joint values by name.
struct MoveItRequest {
  std::string group;
  std::map<std::string, double> start, goal;
};

/// Reads the message in YAML: boxes, cylinders and spheres as they are, meshes as their hulls, the collision
/// matrix. Throws InvalidParameterError, in one line with file and line, for what is not understood: another
/// primitive, planes, an octomap, attached objects, text that is not YAML.
MoveItScene read_moveit_scene(const std::string& path);

/// The same of a request; its goal must be one set of joint constraints.
MoveItRequest read_moveit_request(const std::string& path);

}  // namespace raygauge::cli
