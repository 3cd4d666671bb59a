// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/analysis_options.h"

#include <cstdio>
#include <utility>

#include "raygauge/exceptions.h"
#include "results/run/results_file.h"
#include "results/text/language.h"

namespace raygauge::cli {

void add_analysis_options(Command& command, AnalysisArguments& arguments) {
  command.add_option("files", arguments.files, "Results files; several are joined")
      .required()
      .type_name("FILE.h5")
      .default_str("");
  command
      .add_option("--where", arguments.where,
                  "Use only records for which this holds, as in 'n>=5 && method!=glpk_primal'")
      .type_name("CONDITION");
}

void add_baseline_option(Command& command, std::vector<std::string>& baselines) {
  command
      .add_option("--baseline", baselines,
                  "Methods that ratios refer to, the best of them in each cell; default: GLPK's, or else all "
                  "baselines")
      .delimiter(',')
      .type_name("METHOD,...")
      .default_str("");
}

void require_files(const AnalysisArguments& arguments) {
  for (const std::string& path : arguments.files) require_results(path);
}

void note_checksum(const std::string& path, bool has_checksum) {
  if (has_checksum) return;
  std::fprintf(stderr, "note: %s: %s\n", language::printable(path).c_str(), kNoChecksum);
}

MergedResults read_files(const AnalysisArguments& arguments) {
  MergedResults merged = read_merged(arguments.files);
  for (const MergedFile& file : merged.files) note_checksum(file.path, file.provenance.has_checksum);
  return merged;
}

SceneFile read_scene(const AnalysisArguments& arguments) {
  SceneFile file = read_scene_file(arguments.files.front());
  note_checksum(arguments.files.front(), file.has_checksum);
  return file;
}

Filter filter_of(const AnalysisArguments& arguments) {
  return arguments.where.empty() ? Filter() : Filter(arguments.where);
}

Output output_of(const std::string& path, OutputKind kind, std::vector<std::string> extensions,
                 const AnalysisArguments& arguments, bool force) {
  return decided({path, kind, std::move(extensions), arguments.files, force});
}

void refuse_options_of_scene(const AnalysisArguments& arguments, std::vector<GivenOption> others) {
  others.emplace_back("--where", !arguments.where.empty());
  for (const auto& [option, is_given] : others) {
    if (!is_given) continue;
    throw InvalidParameterError(arguments.files.front() + ": holds the results of a scene, for which " +
                                option + " has no effect");
  }
}

}  // namespace raygauge::cli
