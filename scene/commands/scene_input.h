// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/console/command_line.h"
#include "raygauge/scene/scene_run.h"
#include "scene/file/scene_file.h"
#include "scene/input/scene_source.h"

namespace raygauge::cli {

/// What every command about a scene file takes.
struct SceneInput {
  std::string path;
  std::vector<std::string> overrides;
  std::vector<std::string> packages;
  bool skip_missing_meshes = false;
};

void add_source_options(Command& command, SceneInput& input);

/// --package, --skip-missing-meshes and --max-input alone.
void add_mesh_options(Command& command, SceneInput& input);

RobotMeshes meshes_of(const SceneInput& input);

SceneSource source_of(const SceneInput& input);

/// What the results say of the scene before any of it is computed.
SceneFile head_of(const SceneSource& source, const ScenePlan& plan);

}  // namespace raygauge::cli
