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

/// What every command that stores the results of a scene takes.
struct RunArguments {
  SceneInput input;
  std::string output;
  int threads = 0;
  bool resume = false;
  bool force = false;
  bool quiet = false;
};

void add_source_options(Command& command, SceneInput& input);

/// --output, --threads and --quiet.
void add_run_options(Command& command, RunArguments& arguments);

/// The line of a shell that runs `raygauge scene NAME` on the same input once more.
std::string command_line_of(const std::string& name, const SceneInput& input, const std::string& output);

/// Where the results are, and what makes a page of them.
void print_place(const std::string& path);

/// --package, --skip-missing-meshes and --max-input alone.
void add_mesh_options(Command& command, SceneInput& input);

RobotMeshes meshes_of(const SceneInput& input);

SceneSource source_of(const SceneInput& input);

/// What the results say of the scene before any of it is computed.
SceneFile head_of(const SceneSource& source, const ScenePlan& plan);

}  // namespace raygauge::cli
