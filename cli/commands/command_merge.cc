// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "results/merge/merge_parts.h"
#include "results/run/output_place.h"
#include "results/text/words.h"
#include "scene/file/scene_writer.h"

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
    note_checksum("one of the parts", scene.has_checksum);
    if (arguments.quiet) return kAnswered;
    std::printf("%s: %zu of %s, %s from %s\n", arguments.output.c_str(), scene.cells.size(),
                counted(scene.cell_count, "cell").c_str(), counted(scene.records.size(), "record").c_str(),
                counted(parts.size(), "part").c_str());
    return kAnswered;
  }
  const MergeSummary summary = merge_parts(parts, arguments.output, arguments.options);
  note_checksum("one of the parts", summary.provenance.has_checksum);
  if (arguments.quiet) return kAnswered;
  std::printf("%s: %llu of %s, %s from %s", arguments.output.c_str(),
              static_cast<unsigned long long>(summary.cells),
              counted(summary.provenance.cell_count, "cell").c_str(),
              counted(summary.records, "record").c_str(), counted(parts.size(), "part").c_str());
  if (summary.repeated > 0) {
    std::printf("; %s that several parts hold %s in it once", counted(summary.repeated, "record").c_str(),
                summary.repeated == 1 ? "is" : "are");
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
