// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/commands/scene_input.h"

#include <cerrno>
#include <cstdio>
#include <map>

#include "cli/console/input_options.h"
#include "raygauge/exceptions.h"
#include "results/text/language.h"
#include "scene/page/scene_drawing.h"

namespace raygauge::cli {
namespace {

std::map<std::string, std::string> package_folders(const std::vector<std::string>& options) {
  std::map<std::string, std::string> folders;
  for (const std::string& option : options) {
    const std::size_t equals = option.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw InvalidParameterError("--package " + option + ": must be NAME=FOLDER");
    }
    folders[option.substr(0, equals)] = option.substr(equals + 1);
  }
  return folders;
}

}  // namespace

SceneSource source_of(const SceneInput& input) {
  return read_scene(input.path, input.overrides, meshes_of(input));
}

RobotMeshes meshes_of(const SceneInput& input) {
  return {package_folders(input.packages), input.skip_missing_meshes};
}

SceneFile head_of(const SceneSource& source, const ScenePlan& plan) {
  const Scene& scene = source.scene;
  SceneFile head;
  head.name = scene.name;
  head.text = source.text;
  head.identity = scene_identity(source);
  head.drawing = drawing_of(scene);
  head.cell_count = plan.cells.size();
  for (const Body& body : scene.bodies) {
    head.bodies.push_back({body.name, static_cast<std::int32_t>(body.parts.size())});
  }
  for (std::size_t q = 0; q < scene.queries.size(); ++q) {
    const SceneQuery& query = scene.queries[q];
    head.queries.push_back({query.name, to_string(query.effects), source.metrics[q], query.within,
                            query.nearest, query.tolerance, query.contact});
  }
  return head;
}

void add_source_options(Command& command, SceneInput& input) {
  command.add_option("scene", input.path, "Scene file (TOML; see docs/scenes.md)")
      .required()
      .type_name("SCENE.toml");
  command
      .add_option("--set", input.overrides,
                  "Replace a value of the scene, as in --set time.instants=11; may be repeated")
      .type_name("KEY=VALUE")
      .default_str("")
      .expected(1)
      .take_all();
  add_mesh_options(command, input);
}

void add_run_options(Command& command, RunArguments& arguments) {
  command
      .add_option("-o,--output", arguments.output,
                  "Results file; default: out/NAME.h5, NAME being the scene's")
      .type_name("FILE.h5");
  command.add_option("--threads", arguments.threads, "Threads; 0: one for each core")
      .range(0, 65536)
      .type_name("K");
  command.add_flag("-q,--quiet", arguments.quiet, "Print errors only");
}

std::string command_line_of(const std::string& name, const SceneInput& input, const std::string& output) {
  std::string command = language::shell(program_invocation_name) + " scene " + name + " " +
                        language::shell(input.path) + " -o " + language::shell(output);
  for (const std::string& text : input.overrides) command += " --set " + language::shell(text);
  for (const std::string& text : input.packages) command += " --package " + language::shell(text);
  if (input.skip_missing_meshes) command += " --skip-missing-meshes";
  return command;
}

void print_place(const std::string& path) {
  std::printf("  results    %s\n  next       %s report %s -o %s.html\n", path.c_str(),
              language::shell(program_invocation_name).c_str(), language::shell(path).c_str(),
              language::shell(path.substr(0, path.rfind(".h5"))).c_str());
}

void add_mesh_options(Command& command, SceneInput& input) {
  command
      .add_option("--package", input.packages,
                  "Folder that package://NAME/ in URDF files stands for; may be repeated")
      .type_name("NAME=FOLDER")
      .default_str("")
      .expected(1)
      .take_all();
  command.add_flag("--skip-missing-meshes", input.skip_missing_meshes,
                   "Leave out the meshes of robots that are not there, and name them");
  add_max_input_option(command);
}

}  // namespace raygauge::cli
