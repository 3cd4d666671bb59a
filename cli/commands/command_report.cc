// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <memory>
#include <string>
#include <vector>

#include "analysis/studies/report.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "cli/output/output_file.h"
#include "scene/page/scene_page.h"

namespace raygauge::cli {
namespace {

struct ReportArguments {
  AnalysisArguments analysis;
  std::string output;
  std::vector<std::string> baselines;
  bool force = false;
};

int write_report(const ReportArguments& arguments) {
  const Filter filter = filter_of(arguments.analysis);  // complains before the files are read
  const Output output =
      output_of(arguments.output, OutputKind::text, {".html", ".htm"}, arguments.analysis, arguments.force);
  if (arguments.analysis.files.size() == 1 && is_scene_file(arguments.analysis.files.front())) {
    refuse_options_of_scene(arguments.analysis, {{"--baseline", !arguments.baselines.empty()}});
    write_to(output, scene_page::make_page(read_scene(arguments.analysis)));
    print_path(output);
    return kAnswered;
  }
  write_to(output, report::make_page(read_files(arguments.analysis), filter, arguments.baselines));
  print_path(output);
  return kAnswered;
}

}  // namespace

void add_report_command(Command& app, int& status) {
  const auto arguments = std::make_shared<ReportArguments>();
  Command command = app.add_subcommand(
      "report", "Write one HTML page with everything the records show; it needs no network");
  add_analysis_options(command, arguments->analysis);
  command.add_option("-o,--output", arguments->output, "File to write, - for standard output")
      .required()
      .type_name("FILE.html");
  add_baseline_option(command, arguments->baselines);
  add_force_option(command, arguments->force);
  command.footer(
      "Examples:\n"
      "  raygauge report out/example2.h5 -o out/report.html\n"
      "  raygauge report out/example2.h5 -o out/small.html --where 'n<=5'");
  command.callback([arguments, &status] { status = write_report(*arguments); });
}

}  // namespace raygauge::cli
