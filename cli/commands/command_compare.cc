// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "analysis/render/table.h"
#include "analysis/studies/compare/compare.h"
#include "analysis/studies/compare/compare_circumstances.h"
#include "analysis/studies/compare/compare_tables.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "cli/output/json_text.h"
#include "cli/output/terminal.h"
#include "engine/exceptions.h"
#include "results/run/results_file.h"

namespace raygauge::cli {
namespace {

struct CompareArguments {
  std::string base;
  std::string fresh;
  std::string where;
  double threshold = CompareOptions().threshold;
  double significance = CompareOptions().significance;
  bool json = false;
  bool all = false;
  std::string format = "text";
};

Json ratio_json(const TestedRatio& ratio, double adjusted_p) {
  return {{"ratio", ratio.ratio.ratio},
          {"interval", {ratio.ratio.interval.lower, ratio.ratio.interval.upper}},
          {"p", ratio.p},
          {"adjusted_p", adjusted_p}};
}

Json cell_json(const CellChange& cell) {
  Json result = {{"generator", cell.cell.generator},
                 {"generator_parameters", cell.cell.generator_parameters},
                 {"n", cell.cell.n},
                 {"N", cell.cell.N},
                 {"tolerance", cell.cell.tolerance},
                 {"method", cell.method},
                 {"base_seconds", cell.base_seconds},
                 {"new_seconds", cell.new_seconds},
                 {"ratio_of_medians", cell.medians.ratio},
                 {"ratio_of_medians_interval", {cell.medians.interval.lower, cell.medians.interval.upper}},
                 {"pairs", cell.pairs},
                 {"change", to_string(cell.change)},
                 {"lost", cell.lost}};
  result.update(ratio_json(cell.ratio, cell.adjusted_p));
  return result;
}

Json comparison_json(const Comparison& comparison, const std::vector<std::string>& warnings) {
  Json methods = Json::array();
  for (const MethodChange& method : comparison.methods) {
    Json entry = {{"method", method.method},
                  {"cells", method.cells},
                  {"change", to_string(method.change)},
                  {"lost", method.lost}};
    entry.update(ratio_json(method.ratio, method.adjusted_p));
    methods.push_back(entry);
  }
  Json cells = Json::array();
  for (const CellChange& cell : comparison.cells) cells.push_back(cell_json(cell));
  return {{"regression", comparison.regressed()},
          {"verdict", comparison_verdict(comparison)},
          {"threshold", comparison.options.threshold},
          {"significance", comparison.options.significance},
          {"correction", "Holm"},
          {"contradictions", comparison.contradictions},
          {"base_only", comparison.base_only},
          {"new_only", comparison.new_only},
          {"warnings", warnings},
          {"methods", methods},
          {"cells", cells}};
}

std::vector<std::string> warnings_of(const CompareArguments& arguments, const ResultsFile& base,
                                     const ResultsFile& fresh) {
  std::vector<std::string> warnings = circumstance_differences(base.provenance, fresh.provenance);
  if (!base.finished()) warnings.push_back(arguments.base + " is unfinished");
  if (!fresh.finished()) warnings.push_back(arguments.fresh + " is unfinished");
  return warnings;
}

void print_comparison(const CompareArguments& arguments, const Comparison& comparison,
                      const std::vector<std::string>& warnings) {
  RenderOptions render_as;
  render_as.format = table_format_from_string(arguments.format);
  render_as.color = wants_color(stdout);
  if (render_as.format == TableFormat::csv) {
    std::fputs(render(comparison_long_table(comparison), render_as).c_str(), stdout);
    for (const std::string& warning : warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
    return;
  }
  constexpr std::size_t kMostRows = 20;
  for (const Table& table : comparison_tables(comparison, warnings, arguments.all ? 0 : kMostRows))
    std::printf("%s\n", render(table, render_as).c_str());
  std::printf("%s\n", comparison_verdict(comparison).c_str());
}

int compare(const CompareArguments& arguments) {
  table_format_from_string(arguments.format);  // complains before the files are read
  CompareOptions options;
  options.threshold = arguments.threshold;
  options.significance = arguments.significance;
  if (!arguments.where.empty()) options.filter = Filter(arguments.where);
  options.base_name = arguments.base;
  options.new_name = arguments.fresh;
  const ResultsFile base = read_results(arguments.base);
  const ResultsFile fresh = read_results(arguments.fresh);
  const Comparison comparison = compare_runs(base.records, fresh.records, options);
  const std::vector<std::string> warnings = warnings_of(arguments, base, fresh);
  if (arguments.json) {
    std::printf("%s\n", json_text(comparison_json(comparison, warnings)).c_str());
  } else {
    print_comparison(arguments, comparison, warnings);
  }
  return comparison.regressed() ? kRegression : kAnswered;
}

}  // namespace

void add_compare_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "Compare two runs of one experiment; exit status 1 if the second has become worse");
  command->add_option("base", arguments->base, "Results file to compare with")
      ->required()
      ->type_name("BASE.h5");
  command->add_option("new", arguments->fresh, "Results file to judge")->required()->type_name("NEW.h5");
  command
      ->add_option("--where", arguments->where,
                   "Use only records for which this holds, as in 'n>=5 && method!=glpk_primal'")
      ->type_name("CONDITION");
  command->add_option("--threshold", arguments->threshold, "Changes of no more than this fraction are none")
      ->check(CLI::NonNegativeNumber)
      ->type_name("FRACTION");
  command
      ->add_option("--significance", arguments->significance,
                   "Probability of one false alarm or more, over all cells and methods (Holm)")
      ->type_name("ALPHA");
  command->add_flag("--all", arguments->all, "Show every changed cell, not the 20 most changed");
  command->add_option("--format", arguments->format, "text, markdown, latex, or csv with every cell")
      ->type_name("FORMAT");
  command->add_flag("--json", arguments->json, "Print one JSON object with every cell");
  command->footer(
      "Examples:\n"
      "  raygauge compare out/before.h5 out/after.h5   # exit status 0, or 1 after a regression\n"
      "  raygauge compare out/before.h5 out/after.h5 --threshold 0.1 --json   # exit status 0, or 1 after a "
      "regression");
  command->callback([arguments, &status] { status = compare(*arguments); });
}

}  // namespace raygauge::cli
