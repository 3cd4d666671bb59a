// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <omp.h>

#include <cerrno>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/input/scene_source.h"
#include "cli/interrupt.h"
#include "cli/output/json_text.h"
#include "cli/output/progress.h"
#include "cli/output/scene_drawing.h"
#include "cli/output/scene_text.h"
#include "cli/output/terminal.h"
#include "engine/exceptions.h"
#include "engine/scene/scene_run.h"
#include "results/run/output_place.h"
#include "results/scene/scene_writer.h"

namespace raygauge::cli {
namespace {

struct SceneArguments {
  std::string path;
  std::string output;
  std::vector<std::string> overrides;
  std::vector<std::string> packages;
  int threads = 0;
  bool resume = false;
  bool force = false;
  bool quiet = false;
  bool json = false;
};

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

SceneSource source_of(const SceneArguments& arguments) {
  return read_scene(arguments.path, arguments.overrides, package_folders(arguments.packages));
}

/// What the results say of the scene before any of it is computed.
SceneFile head_of(const SceneSource& source, const ScenePlan& plan, int threads) {
  const Scene& scene = source.scene;
  SceneFile head;
  head.name = scene.name;
  head.text = source.text;
  head.identity = scene_identity(source);
  head.drawing = drawing_of(scene);
  head.cell_count = plan.cells.size();
  Experiment experiment;
  head.sessions = {describe_session(experiment, threads, {})};
  for (const Body& body : scene.bodies) {
    head.bodies.push_back({body.name, static_cast<std::int32_t>(body.parts.size())});
  }
  for (std::size_t q = 0; q < scene.queries.size(); ++q) {
    const SceneQuery& query = scene.queries[q];
    head.queries.push_back({query.name, source.effects[q], source.metrics[q], query.within, query.nearest,
                            query.tolerance, query.contact});
  }
  return head;
}

std::string resume_command(const SceneArguments& arguments, const std::string& output) {
  std::string command = shell_word(program_invocation_name) + " scene run " + shell_word(arguments.path) +
                        " -o " + shell_word(output);
  for (const std::string& text : arguments.overrides) command += " --set " + shell_word(text);
  for (const std::string& text : arguments.packages) command += " --package " + shell_word(text);
  return command + " --resume";
}

void print_end(const SceneFile& file, const SceneSummary& summary, const std::string& path) {
  std::printf("%s: %llu cells in %s on %d %s; %zu records\n", file.name.c_str(),
              static_cast<unsigned long long>(summary.cells_done),
              duration_text(summary.wall_seconds).c_str(), summary.threads,
              summary.threads == 1 ? "thread" : "threads", file.records.size());
  std::fputs(tally_text(file).c_str(), stdout);
  std::fputs(event_text(file).c_str(), stdout);
  std::printf("  results    %s\n  next       %s report %s -o %s.html\n", path.c_str(),
              shell_word(program_invocation_name).c_str(), shell_word(path).c_str(),
              shell_word(path.substr(0, path.rfind(".h5"))).c_str());
}

int run_scene_file(const SceneArguments& arguments) {
  const SceneSource source = source_of(arguments);
  const ScenePlan plan = plan_scene(source.scene);
  const std::string path = arguments.output.empty() ? "out/" + source.scene.name + ".h5" : arguments.output;
  output_place({path, OutputKind::results, {".h5", ".hdf5"}, {arguments.path}, arguments.force});
  const int threads = arguments.threads > 0 ? arguments.threads : omp_get_num_procs();
  RunMode mode = arguments.force ? RunMode::force : RunMode::create;
  if (arguments.resume) mode = RunMode::resume;
  SceneWriter writer(path, head_of(source, plan, threads), mode);
  const std::size_t done_before = writer.done().size();
  const InterruptGuard guard(arguments.quiet ? nullptr : "\ninterrupted: finishing the cells in flight\n");
  ProgressDisplay display(stderr, done_before);
  SceneHooks hooks;
  hooks.stop = [] { return InterruptGuard::signal() != 0; };
  hooks.progress = [&](const SceneProgress& progress) {
    if (arguments.quiet) return;
    const double left = static_cast<double>(progress.cells_total - progress.cells_done);
    display.show({progress.cells_done, progress.cells_total, progress.seconds,
                  progress.seconds * left / static_cast<double>(progress.cells_done)});
  };
  const SceneSummary summary = run_scene(source.scene, plan, threads, writer.done(), writer, hooks);
  display.clear();
  if (summary.stopped) {
    std::fprintf(stderr, "interrupted: %zu of %zu cells are safe; continue with\n  %s\n",
                 done_before + summary.cells_done, plan.cells.size(),
                 resume_command(arguments, path).c_str());
    return kInterrupted + InterruptGuard::signal() - SIGINT;
  }
  writer.finish();
  if (!arguments.quiet) print_end(writer.results(), summary, path);
  return kAnswered;
}

int explain(const SceneArguments& arguments) {
  const SceneSource source = source_of(arguments);
  const ScenePlan plan = plan_scene(source.scene);
  Json json;
  json["scene"] = source.scene.name;
  json["bodies"] = source.scene.bodies.size();
  json["instants"] = source.scene.instants.size();
  json["cells"] = plan.cells.size();
  std::string text = source.scene.name + ": " + std::to_string(source.scene.bodies.size()) + " bodies, " +
                     std::to_string(source.scene.instants.size()) + " instants, " +
                     std::to_string(plan.cells.size()) + " cells of work\n";
  for (std::size_t q = 0; q < source.scene.queries.size(); ++q) {
    Json query;
    query["name"] = source.scene.queries[q].name;
    query["effects"] = source.effects[q];
    query["pairs"] = pairs_of(source.scene, source.scene.queries[q]).size();
    text += source.scene.queries[q].name + " (" + source.effects[q] + ")\n";
    for (const std::string& line : explain_query(source.scene, plan, static_cast<int>(q))) {
      text += "  " + line + "\n";
      query["plan"].push_back(line);
    }
    json["queries"].push_back(query);
  }
  std::fputs(arguments.json ? (json_text(json) + "\n").c_str() : text.c_str(), stdout);
  return kAnswered;
}

void add_source_options(Command& command, SceneArguments& arguments) {
  command.add_option("scene", arguments.path, "Scene file (TOML; see docs/scenes.md)")
      .required()
      .type_name("SCENE.toml");
  command
      .add_option("--set", arguments.overrides,
                  "Replace a value of the scene, as in --set time.instants=11; may be repeated")
      .type_name("KEY=VALUE")
      .default_str("")
      .expected(1)
      .take_all();
  command
      .add_option("--package", arguments.packages,
                  "Folder that package://NAME/ in URDF files stands for; may be repeated")
      .type_name("NAME=FOLDER")
      .default_str("")
      .expected(1)
      .take_all();
}

}  // namespace

void add_scene_command(Command& app, int& status) {
  const auto arguments = std::make_shared<SceneArguments>();
  Command scene = app.add_subcommand("scene", "Bodies that move: answer what a scene file asks, with proof");
  scene.require_subcommand();
  Command run = scene.add_subcommand("run", "Answer every query of a scene and store the answers");
  add_source_options(run, *arguments);
  run.add_option("-o,--output", arguments->output,
                 "Results file; default: out/NAME.h5, NAME being the scene's")
      .type_name("FILE.h5");
  run.add_option("--threads", arguments->threads, "Threads; 0: one for each core")
      .range(0, 65536)
      .type_name("K");
  const Option resume =
      run.add_flag("--resume", arguments->resume, "Continue a run that was killed or interrupted");
  run.add_flag("--force", arguments->force, "Replace an existing results file").excludes(resume);
  run.add_flag("-q,--quiet", arguments->quiet, "Print errors only");
  run.callback([arguments, &status] { status = run_scene_file(*arguments); });
  Command plan =
      scene.add_subcommand("explain", "Print what will be computed for which pairs, what never, and why");
  add_source_options(plan, *arguments);
  plan.add_flag("--json", arguments->json, "Print one JSON object");
  plan.callback([arguments, &status] { status = explain(*arguments); });
}

}  // namespace raygauge::cli
