// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cli/commands/commands.h"
#include "cli/output/build_report.h"
#include "cli/output/file_report.h"
#include "cli/output/shard_report.h"
#include "results/disk/run_directory.h"
#include "results/run/results_file.h"
#include "scene/commands/scene_text.h"

namespace raygauge::cli {
namespace {

constexpr const char* kInfoFooter =
    "Examples:\n"
    "  raygauge info\n"
    "  raygauge info out/example2.h5\n"
    "  raygauge info out/example2.h5 --json\n"
    "\n"
    "Exit status: 0, or 2 for a file that is missing, damaged or no results file.";

struct InfoArguments {
  std::string path;
  bool json = false;
};

/// Of a run whose shards are not merged yet.
std::string unmerged_report(const InfoArguments& arguments, const ShardReport& shards) {
  if (!arguments.json) {
    return labelled("file", arguments.path + " (not merged yet)") +
           labelled("experiment", shards.experiment) + shards_text(shards);
  }
  Json json = shards_json(shards);
  json["file"] = arguments.path;
  json["experiment"] = shards.experiment;
  return json_text(json) + "\n";
}

std::string report(const InfoArguments& arguments) {
  if (arguments.path.empty()) return arguments.json ? json_text(build_json()) + "\n" : build_text();
  if (is_scene_file(arguments.path)) {
    const SceneFile scene = read_scene_file(arguments.path);
    return arguments.json ? json_text(scene_info_json(arguments.path, scene)) + "\n"
                          : scene_info_text(arguments.path, scene);
  }
  const bool there = std::filesystem::exists(arguments.path) || !list_parts(arguments.path).sessions.empty();
  const std::optional<ShardReport> shards = there ? std::nullopt : shard_report(arguments.path);
  if (shards) return unmerged_report(arguments, *shards);
  const ResultsFile results = read_results(arguments.path);
  return arguments.json ? json_text(results_json(arguments.path, results)) + "\n"
                        : results_text(arguments.path, results);
}

}  // namespace

void add_info_command(Command& app, int& status) {
  const auto arguments = std::make_shared<InfoArguments>();
  Command command =
      app.add_subcommand("info", "This build, machine and its solvers; or what a results file holds");
  command
      .add_option(
          "file", arguments->path,
          "Results file, of a finished run or an unfinished one, or of one whose shards are not merged; "
          "without it: build, machine, methods, "
          "generators, shapes of set files")
      .type_name("FILE.h5");
  command.add_flag("--json", arguments->json, "Print one JSON object");
  command.footer(kInfoFooter);
  command.callback([arguments, &status] {
    std::fputs(report(*arguments).c_str(), stdout);
    status = kAnswered;
  });
}

}  // namespace raygauge::cli
