// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/analysis_options.h"

#include <utility>

#include "raygauge/exceptions.h"

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

MergedResults read_files(const AnalysisArguments& arguments) { return read_merged(arguments.files); }

Filter filter_of(const AnalysisArguments& arguments) {
  return arguments.where.empty() ? Filter() : Filter(arguments.where);
}

OutputRequest output_request(const std::string& path, OutputKind kind, std::vector<std::string> extensions,
                             const AnalysisArguments& arguments, bool force) {
  OutputRequest request = {path, kind, std::move(extensions), arguments.files, force};
  output_place(request);
  return request;
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
