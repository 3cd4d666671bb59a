// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/input/toml_source.h"
#include "raygauge/scene/scene.h"
#include "scene/input/robot_file.h"
#include "scene/input/srdf_file.h"

namespace raygauge::cli {

/// The links of a robot that have collision shapes, as bodies of a scene.
struct RobotBodies {
  std::string name;
  std::vector<Body> bodies;                 ///< called ROBOT/LINK
  std::vector<std::pair<int, int>> joined;  ///< bodies that a joint joins, also over links without a shape,
                                            ///< and those that its files disable
  std::vector<std::string> notes;           ///< meshes left out, joint values beyond their limits
  Robot robot;
  RobotSemantics semantics;  ///< empty without an SRDF file
  Placement base;
  std::vector<int> links;  ///< of each body
  bool has_trajectory = false;
};

/// The keys of [[robot]]; the last one is for the scene.
const std::vector<std::string>& robot_keys();

/// Reads a [[robot]] table whose names start at `folder`. Without a trajectory the joints stand at 0 from
/// time `from` to `to`. Throws Error, with file and line.
RobotBodies read_robot_bodies(const toml::table& table, const std::filesystem::path& folder, double from,
                              double to, const RobotMeshes& meshes);

/// The pairs among the `count` bodies from number `first` on that a query of the scene is about and that
/// meet, or nearly, at the first instant: one line with the `ignore` that leaves them out. Empty: there are
/// none.
std::string note_of_contacts(const Scene& scene, const std::string& robot, int first, int count);

}  // namespace raygauge::cli
