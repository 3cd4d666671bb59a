// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/output/counted.h"
#include "results/merge/merge_parts.h"
#include "results/run/output_place.h"
#include "results/scene/scene_writer.h"

namespace raygauge::cli {
namespace {

constexpr const char* kMergeFooter =
    "The parts stay as they are. Exit status: 0, or 2 where nothing was written: parts of different "
    "experiments or builds, answers that contradict each other, missing cells, a part that is being written.";

struct MergeArguments {
  std::vector<std::string> parts;
  std::string output;
  MergeOptions options;
  bool quiet = false;
};

int merge(const MergeArguments& arguments) {
  output_place({arguments.output, OutputKind::results, {".h5", ".hdf5"}, arguments.parts, false});
  const std::vector<std::filesystem::path> parts(arguments.parts.begin(), arguments.parts.end());
  if (is_scene_file(parts.front())) {
    const SceneFile scene = merge_scenes(parts, arguments.output, arguments.options);
    if (arguments.quiet) return kAnswered;
    std::printf("%s: %zu of %llu cells, %zu records from %s\n", arguments.output.c_str(), scene.cells.size(),
                static_cast<unsigned long long>(scene.cell_count), scene.records.size(),
                counted(static_cast<std::int64_t>(parts.size()), "part").c_str());
    return kAnswered;
  }
  const MergeSummary summary = merge_parts(parts, arguments.output, arguments.options);
  if (arguments.quiet) return kAnswered;
  std::printf("%s: %llu of %llu cells, %llu records from %zu %s", arguments.output.c_str(),
              static_cast<unsigned long long>(summary.cells),
              static_cast<unsigned long long>(summary.provenance.cell_count),
              static_cast<unsigned long long>(summary.records), parts.size(),
              parts.size() == 1 ? "part" : "parts");
  if (summary.repeated > 0) {
    std::printf("; %llu records that several parts hold are in it once",
                static_cast<unsigned long long>(summary.repeated));
  }
  std::printf("\n");
  return kAnswered;
}

}  // namespace

void add_merge_command(Command& app, int& status) {
  const auto arguments = std::make_shared<MergeArguments>();
  Command command =
      app.add_subcommand("merge", "Join the parts of one experiment, such as shards, into one file");
  command.add_option("parts", arguments->parts, "Results files, finished or not")
      .required()
      .type_name("PART.h5...");
  command.add_option("-o,--output", arguments->output, "Results file; must not exist yet")
      .required()
      .type_name("FILE.h5");
  command.add_flag("--partial", arguments->options.partial, "Merge even if cells are missing");
  command.add_flag("--mixed-builds", arguments->options.mixed_builds,
                   "Merge parts of different builds of raygauge or its solvers");
  command.add_flag("-q,--quiet", arguments->quiet, "Print errors only");
  command.footer(kMergeFooter);
  command.callback([arguments, &status] { status = merge(*arguments); });
}

}  // namespace raygauge::cli
