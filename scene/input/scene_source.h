// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "raygauge/scene/scene.h"
#include "raygauge/simulation.h"
#include "scene/input/plan_table.h"
#include "scene/input/robot_file.h"

namespace raygauge::cli {

inline constexpr const char* kOwnEngine = "raygauge";

/// A scene as its file has it.
struct SceneSource {
  Scene scene;
  std::optional<Dynamics> dynamics;  ///< of [dynamics], as fine as the last of ...
  std::vector<SimulationAccuracy>
      accuracies;  ///< ... each combination of its steps and tolerances, from coarse to fine
  std::vector<std::string> engines;  ///< dynamics.engine; kOwnEngine is the last, where it is asked for
  std::string text;                  ///< the TOML source
  std::vector<std::string> metrics;  ///< by query: "euclidean", or the shape of the unit ball
  std::vector<std::string> notes;    ///< what is worth knowing of robots and meshes, one line each
  std::optional<PlanTable> plan;     ///< [plan], where there is one
};

/// Sets the accuracies, and those of the dynamics to the finest.
void set_accuracies(SceneSource& source, std::vector<SimulationAccuracy> accuracies);

/// The keys that a scene file may have, by table: "" (the file itself), time, body, robot, plan, query.
const std::map<std::string, std::vector<std::string>>& scene_keys();

/// Reads a scene file (TOML; see docs/scenes.md) and all that it names; `meshes` says where those of robots
/// are. Throws Error, with file and line.
SceneSource read_scene(const std::string& path, const std::vector<std::string>& overrides,
                       const RobotMeshes& meshes);

/// What makes two scenes the same for a resume: "key = value" lines of instants, bodies and where they are,
/// and queries.
std::string scene_identity(const SceneSource& source);

}  // namespace raygauge::cli
