// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "analysis/render/table.h"
#include "analysis/studies/compare/compare.h"
#include "analysis/studies/compare/compare_circumstances.h"
#include "analysis/studies/compare/compare_tables.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "cli/commands/rerun.h"
#include "cli/output/json_text.h"
#include "cli/output/terminal.h"
#include "engine/numerics/number_text.h"
#include "raygauge/exceptions.h"
#include "results/run/results_file.h"
#include "results/text/language.h"
#include "results/text/words.h"
#include "scene/file/scene_file.h"

namespace raygauge::cli {
namespace {

struct CompareArguments {
  std::vector<std::string> files;  ///< BASE.h5 NEW.h5
  std::vector<std::string> base;
  std::vector<std::string> fresh;
  RerunPlan rerun;
  bool quiet = false;
  std::string where;
  double threshold = CompareOptions().threshold;
  double significance = CompareOptions().significance;
  bool json = false;
  bool all = false;
  std::string format = "text";
};

Json finding_json(const Finding& finding) {
  const Ratio& ratio = finding.ratio.ratio;
  return {{"ratio", ratio.ratio},
          {"interval", {ratio.interval.lower, ratio.interval.upper}},
          {"p", finding.ratio.p},
          {"adjusted_p", finding.adjusted_p},
          {"run_p", finding.run_p},
          {"run_spread", finding.run_spread},
          {"change", to_string(finding.change)},
          {"lost", finding.lost}};
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
                 {"pairs", cell.pairs}};
  result.update(finding_json(cell));
  return result;
}

Json comparison_json(const Comparison& comparison, const std::vector<std::string>& warnings) {
  Json methods = Json::array();
  for (const MethodChange& method : comparison.methods) {
    Json entry = {{"method", method.method}, {"cells", method.cells}};
    entry.update(finding_json(method));
    methods.push_back(entry);
  }
  Json cells = Json::array();
  for (const CellChange& cell : comparison.cells) cells.push_back(cell_json(cell));
  return {{"regression", comparison.regressed()},
          {"suspected", comparison.suspicious()},
          {"base_runs", comparison.base_runs},
          {"new_runs", comparison.new_runs},
          {"paired", comparison.options.paired},
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

/// Both sides, and what else may have changed the times.
struct Sides {
  Runs base;
  Runs fresh;
  std::vector<std::string> warnings;
};

/// The files of one side. The same file twice would count its run twice.
std::vector<ResultsFile> read_side(const std::vector<std::string>& paths,
                                   std::vector<std::string>& warnings) {
  std::set<std::filesystem::path> seen;
  std::vector<ResultsFile> files;
  for (const std::string& path : paths) {
    if (is_scene_file(path))
      throw InvalidParameterError(path + ": holds the results of a scene; compare takes those of sweeps");
    files.push_back(read_results(path));
    note_checksum(path, files.back().provenance.has_checksum);
    if (!seen.insert(std::filesystem::weakly_canonical(path)).second)
      throw InvalidParameterError(path + " is given twice on one side: its run would count twice");
    if (!files.back().finished()) warnings.push_back(path + " is unfinished");
  }
  return files;
}

Sides sides_of_files(const CompareArguments& arguments) {
  Sides sides;
  std::vector<std::string> unfinished;
  std::vector<ResultsFile> base = read_side(arguments.base, unfinished);
  std::vector<ResultsFile> fresh = read_side(arguments.fresh, unfinished);
  for (const ResultsFile& before : base) {
    for (const ResultsFile& after : fresh)
      for (std::string& warning : circumstance_differences(before.provenance, after.provenance))
        if (std::find(sides.warnings.begin(), sides.warnings.end(), warning) == sides.warnings.end())
          sides.warnings.push_back(std::move(warning));
  }
  sides.warnings.insert(sides.warnings.end(), unfinished.begin(), unfinished.end());
  for (ResultsFile& file : base) sides.base.push_back(std::move(file.records));
  for (ResultsFile& file : fresh) sides.fresh.push_back(std::move(file.records));
  return sides;
}

Sides sides_of_rerun(const CompareArguments& arguments) {
  RerunResult result = run_pairs(arguments.rerun, arguments.quiet);
  return {std::move(result.base), std::move(result.fresh),
          circumstance_differences(result.base_provenance, result.new_provenance)};
}

/// Which of the three ways to name the two sides was taken; complains about a mixture.
bool wants_rerun(CompareArguments& arguments) {
  const bool rerun = !arguments.rerun.experiment_path.empty();
  if (rerun != !arguments.rerun.base_program.empty() || rerun != !arguments.rerun.new_program.empty())
    throw InvalidParameterError("--rerun EXPERIMENT, --base-program and --new-program go together");
  if (!rerun && !arguments.rerun.overrides.empty())
    throw InvalidParameterError("--set changes the experiment of --rerun, which is not given");
  const int ways = (rerun ? 1 : 0) + (arguments.files.empty() ? 0 : 1) +
                   (arguments.base.empty() && arguments.fresh.empty() ? 0 : 1);
  if (!arguments.files.empty()) {
    arguments.base = {arguments.files.front()};
    arguments.fresh = {arguments.files.back()};
  }
  const bool files = !arguments.base.empty() && !arguments.fresh.empty();
  if (ways == 1 && (rerun || (files && arguments.files.size() != 1 && arguments.files.size() < 3)))
    return rerun;
  throw InvalidParameterError(
      "compare takes BASE.h5 NEW.h5, or --base FILES --new FILES, or --rerun EXPERIMENT with two programs");
}

void print_comparison(const CompareArguments& arguments, const Comparison& comparison,
                      const std::vector<std::string>& warnings) {
  RenderOptions render_as;
  render_as.format = table_format_from_string(arguments.format);
  render_as.color = wants_color(stdout);
  if (render_as.format == TableFormat::csv) {
    std::fputs(render(comparison_long_table(comparison), render_as).c_str(), stdout);
    for (const std::string& warning : warnings)
      std::fprintf(stderr, "warning: %s\n", language::printable(warning).c_str());
    return;
  }
  constexpr std::size_t kMostRows = 20;
  for (const Table& table : comparison_tables(comparison, warnings, arguments.all ? 0 : kMostRows))
    std::printf("%s\n", render(table, render_as).c_str());
  std::printf("%s\n", language::printable(comparison_verdict(comparison)).c_str());
}

/// Before the files are read, or two builds are run for hours.
void check_options(const CompareArguments& arguments) {
  if (table_format_from_string(arguments.format) == TableFormat::csv && arguments.all)
    throw InvalidParameterError("--all has no effect beside --format csv, which shows every cell");
  if (!(arguments.threshold >= 0) || std::isinf(arguments.threshold)) {
    throw InvalidParameterError("--threshold must be a number from 0 on, got " +
                                rounded_text(arguments.threshold, 6));
  }
  if (!(arguments.significance > 0 && arguments.significance < 1)) {
    throw InvalidParameterError("--significance must lie in (0, 1), got " +
                                rounded_text(arguments.significance, 6));
  }
}

int compare(CompareArguments& arguments) {
  check_options(arguments);
  CompareOptions options;
  options.threshold = arguments.threshold;
  options.significance = arguments.significance;
  if (!arguments.where.empty()) options.filter = Filter(arguments.where);
  options.paired = wants_rerun(arguments);
  const Sides sides = options.paired ? sides_of_rerun(arguments) : sides_of_files(arguments);
  options.base_name = options.paired ? arguments.rerun.base_program : joined(arguments.base);
  options.new_name = options.paired ? arguments.rerun.new_program : joined(arguments.fresh);
  const Comparison comparison = compare_runs(sides.base, sides.fresh, options);
  if (arguments.json) {
    std::printf("%s\n", json_text(comparison_json(comparison, sides.warnings)).c_str());
  } else {
    print_comparison(arguments, comparison, sides.warnings);
  }
  return comparison.regressed() ? kRegression : kAnswered;
}

/// Returns --rerun.
Option add_sides(Command& command, CompareArguments& arguments) {
  command.add_option("files", arguments.files, "Results file to compare with, and the one to judge")
      .expected(0, 2)
      .type_name("BASE.h5 NEW.h5")
      .default_str("");
  command.add_option("--base", arguments.base, "Results files to compare with, one a run")
      .type_name("FILE.h5 ...")
      .default_str("");
  command.add_option("--new", arguments.fresh, "Results files to judge, one a run")
      .type_name("FILE.h5 ...")
      .default_str("");
  Option rerun = command.add_option("--rerun", arguments.rerun.experiment_path,
                                    "Run this experiment with two builds in turn, and judge the pairs");
  rerun.type_name("EXPERIMENT.toml");
  command.add_option("--base-program", arguments.rerun.base_program, "The build to compare with")
      .type_name("PROGRAM");
  command.add_option("--new-program", arguments.rerun.new_program, "The build to judge").type_name("PROGRAM");
  constexpr int kMostPairs = 1000;
  command
      .add_option("--pairs", arguments.rerun.pairs,
                  "Pairs of runs; 5 are the fewest that can prove a change of one cell")
      .range(1, kMostPairs)
      .needs(rerun)
      .type_name("K");
  command
      .add_option("--set", arguments.rerun.overrides,
                  "Replace a value of the experiment, as in --set sweep.n=3,4; may be repeated")
      .type_name("KEY=VALUE")
      .default_str("")
      .expected(1)
      .take_all();
  return rerun;
}

}  // namespace

void add_compare_command(Command& app, int& status) {
  const auto arguments = std::make_shared<CompareArguments>();
  Command command = app.add_subcommand(
      "compare", "Compare runs of one experiment; exit status 1 if the new ones have become worse");
  const Option rerun = add_sides(command, *arguments);
  command
      .add_option("--where", arguments->where,
                  "Use only records for which this holds, as in 'n>=5 && method!=glpk_primal'")
      .type_name("CONDITION");
  command.add_option("--threshold", arguments->threshold, "Changes of no more than this fraction are none")
      .type_name("FRACTION");
  command
      .add_option("--significance", arguments->significance,
                  "Probability of one false alarm or more, over all cells and methods ")
      .type_name("ALPHA");
  const Option all =
      command.add_flag("--all", arguments->all, "Show every changed cell, not the 20 most changed");
  Option format =
      command.add_option("--format", arguments->format, "text, markdown, latex, or csv with every cell");
  format.type_name("FORMAT");
  command.add_flag("-q,--quiet", arguments->quiet, "Do not tell the progress of --rerun").needs(rerun);
  command.add_flag("--json", arguments->json, "Print one JSON object with every cell")
      .excludes(all)
      .excludes(format);
  command.footer(
      "Examples:\n"
      "  raygauge compare out/before.h5 out/after.h5   # exit status 0, or 1 after a regression\n"
      "  raygauge compare --base out/a1.h5 out/a2.h5 --new out/b1.h5 out/b2.h5   # exit status 0, or 1 after "
      "a "
      "regression\n"
      "  raygauge compare --rerun experiments/smoke.toml --base-program raygauge --new-program raygauge "
      "--pairs 5   # exit status 0, or 1 after a regression");
  command.callback([arguments, &status] { status = compare(*arguments); });
}

}  // namespace raygauge::cli
