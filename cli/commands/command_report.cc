// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "analysis/render/report/report.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "results/run/atomic_file.h"

namespace raygauge::cli {
namespace {

struct ReportArguments {
  AnalysisArguments analysis;
  std::string output;
  std::vector<std::string> baselines;
};

int write_report(const ReportArguments& arguments) {
  const Filter filter = filter_of(arguments.analysis);  // complains before the files are read
  write_atomically(arguments.output,
                   report::make_page(read_files(arguments.analysis), filter, arguments.baselines));
  std::printf("%s\n", arguments.output.c_str());
  return kAnswered;
}

}  // namespace

void add_report_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand(
      "report", "Write one HTML page with everything the records show; it needs no network");
  add_analysis_options(*command, arguments->analysis);
  command->add_option("-o,--output", arguments->output, "File to write")->required()->type_name("FILE.html");
  add_baseline_option(*command, arguments->baselines);
  command->footer(
      "Examples:\n"
      "  raygauge report out/example2.h5 -o out/report.html\n"
      "  raygauge report out/example2.h5 -o out/small.html --where 'n<=5'");
  command->callback([arguments, &status] { status = write_report(*arguments); });
}

}  // namespace raygauge::cli
