// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/render/table.h"
#include "analysis/studies/accuracy/accuracy_tables.h"
#include "analysis/studies/example1/example1_table.h"
#include "analysis/studies/pivot/pivot.h"
#include "analysis/studies/pivot/pivot_table.h"
#include "analysis/studies/stability/stability.h"
#include "analysis/studies/table3/table3.h"
#include "analysis/studies/table3/table3_tables.h"
#include "analysis/studies/wrong_answers/wrong_answers.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "cli/output/output_file.h"
#include "cli/output/terminal.h"
#include "raygauge/exceptions.h"
#include "results/text/language.h"
#include "scene/commands/scene_text.h"

namespace raygauge::cli {
namespace {

struct TableArguments {
  AnalysisArguments analysis;
  std::string paper;
  bool stability = false;
  bool accuracy = false;
  bool wrong = false;
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  std::optional<std::string> value;
  std::vector<std::string> baselines;
  bool intervals = false;
  std::string format = "text";
  std::string output;
  bool force = false;
};

/// Of files that hold tables of a format.
std::vector<std::string> extensions_of(TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return {".txt"};
    case TableFormat::markdown:
      return {".md", ".markdown"};
    case TableFormat::latex:
      return {".tex"};
    case TableFormat::csv:
      return {".csv"};
  }
  return {};
}

/// Tables for a person to read where there is no terminal to ask.
constexpr std::size_t kDefaultWidth = 200;

void require_one_kind(const TableArguments& arguments) {
  const bool pivot = !arguments.rows.empty() || !arguments.columns.empty() || arguments.value;
  std::vector<std::string> kinds;
  if (!arguments.paper.empty()) kinds.emplace_back("--paper");
  if (arguments.stability) kinds.emplace_back("--stability");
  if (arguments.accuracy) kinds.emplace_back("--accuracy");
  if (arguments.wrong) kinds.emplace_back("--wrong");
  if (kinds.empty() && !pivot)
    throw InvalidParameterError("table: which table? " + arguments.analysis.files.front() +
                                " is read; add --paper table1|table2|table3, "
                                "--stability, --accuracy, --wrong, or --rows, --cols and --value");
  if (kinds.size() > 1) throw InvalidParameterError("table: " + kinds[0] + " or " + kinds[1] + ", not both");
  if (pivot && !kinds.empty())
    throw InvalidParameterError("table: " + kinds[0] +
                                " has its own rows, columns and value; drop --rows, --cols, --value");
  if (!kinds.empty() && arguments.intervals)
    throw InvalidParameterError("table: --intervals has no effect on " + kinds[0]);
  if (!kinds.empty() && arguments.paper.empty() && !arguments.baselines.empty())
    throw InvalidParameterError("table: --baseline has no effect on " + kinds[0]);
}

/// For CSV the long table of a kind alone, else its tables for reading.
template <class Content>
std::vector<Table> in_format(TableFormat format, const Content& content, Table (*long_table)(const Content&),
                             std::vector<Table> (*tables)(const Content&)) {
  if (format == TableFormat::csv) return {long_table(content)};
  return tables(content);
}

std::vector<Table> paper_tables(const TableArguments& arguments, const std::vector<Record>& records,
                                const Filter& filter, TableFormat format) {
  static const std::map<std::string, Example1Roles> kExample1 = {{"table1", Example1Roles::cone_ellipsoid},
                                                                 {"table2", Example1Roles::ellipsoid_cone}};
  if (arguments.paper == "table3")
    return in_format(format, make_table3(records, filter, arguments.baselines), table3_long_table,
                     table3_tables);
  const auto example1 = kExample1.find(arguments.paper);
  if (example1 == kExample1.end())
    throw UnknownNameError("table of the paper", arguments.paper, {"table1", "table2", "table3"});
  return in_format(format, make_example1_table(records, example1->second, filter, arguments.baselines),
                   example1_long_table, example1_tables);
}

std::vector<Table> tables_of(const TableArguments& arguments, const std::vector<Record>& records,
                             TableFormat format) {
  const Filter filter = filter_of(arguments.analysis);
  if (!arguments.paper.empty()) return paper_tables(arguments, records, filter, format);
  if (arguments.stability)
    return in_format(format, make_stability(records, filter), stability_long_table, stability_tables);
  if (arguments.accuracy)
    return in_format(format, accuracy_groups(records, filter), accuracy_long_table, accuracy_tables);
  if (arguments.wrong)
    return in_format(format, wrong_answers(records, filter), wrong_answers_long_table, wrong_answers_tables);
  PivotOptions options;
  options.rows = arguments.rows;
  options.columns = arguments.columns;
  if (arguments.value) options.value = *arguments.value;
  options.filter = filter;
  options.baselines = arguments.baselines;
  return {pivot_table(make_pivot(records, options), arguments.intervals, arguments.format == "csv")};
}

RenderOptions render_options(const TableArguments& arguments, TableFormat format) {
  RenderOptions options;
  options.format = format;
  if (!arguments.output.empty() && arguments.output != "-") return options;
  const std::size_t width = terminal_width(stdout);
  options.width = width > 0 ? width : kDefaultWidth;
  options.color = wants_color(stdout);
  return options;
}

/// A scene's results have one table, plain text.
bool printed_scene(const TableArguments& arguments) {
  const std::vector<std::string>& files = arguments.analysis.files;
  if (files.size() != 1 || !is_scene_file(files.front())) return false;
  refuse_options_of_scene(arguments.analysis, {{"--paper", !arguments.paper.empty()},
                                               {"--stability", arguments.stability},
                                               {"--accuracy", arguments.accuracy},
                                               {"--wrong", arguments.wrong},
                                               {"--rows", !arguments.rows.empty()},
                                               {"--cols", !arguments.columns.empty()},
                                               {"--value", arguments.value.has_value()},
                                               {"--intervals", arguments.intervals},
                                               {"--baseline", !arguments.baselines.empty()},
                                               {"--format", arguments.format != "text"}});
  const Output output = output_of(arguments.output.empty() ? "-" : arguments.output, OutputKind::text,
                                  {".txt", ".csv"}, arguments.analysis, arguments.force);
  write_to(output, scene_table_text(read_scene(arguments.analysis)));
  return true;
}

int print_table(const TableArguments& arguments) {
  require_files(arguments.analysis);
  if (printed_scene(arguments)) return kAnswered;
  require_one_kind(arguments);
  const TableFormat format = table_format_from_string(arguments.format);
  const Output output = output_of(arguments.output.empty() ? "-" : arguments.output, OutputKind::text,
                                  extensions_of(format), arguments.analysis, arguments.force);
  const MergedResults merged = read_files(arguments.analysis);
  std::vector<Table> tables = tables_of(arguments, merged.records, format);
  Table& last = tables.back();
  last.notes.insert(last.notes.end(), merged.notes.begin(), merged.notes.end());

  std::string text;
  for (const Table& table : tables) {
    if (!text.empty()) text += '\n';
    text += render(table, render_options(arguments, format));
  }
  write_to(output, text);
  if (format == TableFormat::csv) {
    for (const std::string& note : last.notes)
      std::fprintf(stderr, "note: %s\n", language::printable(note).c_str());
  }
  return kAnswered;
}

void add_pivot_options(Command& command, TableArguments& arguments) {
  command.add_option("--rows", arguments.rows, "Columns of the records whose values make the rows, as in n")
      .delimiter(',')
      .type_name("COLUMN,...")
      .default_str("");
  command
      .add_option("--cols", arguments.columns,
                  "Columns of the records whose values make the columns, as in N")
      .delimiter(',')
      .type_name("COLUMN,...")
      .default_str("");
  command
      .add_option(
          "--value", arguments.value,
          "What a cell shows: median, mean, geomean, sgm10 (geometric mean shifted by 10), min, max, sum, "
          "q1, "
          "q3, p90 or outliers of a column or of \"ratio\" (time over the best baseline's), as in \"median "
          "ratio\"; share of a column of true and false, as in \"share solved\"; or count, failures, "
          "disagreements; default: median milliseconds")
      .type_name("AGGREGATE COLUMN");
  command.add_flag("--intervals", arguments.intervals, "Show 95 % intervals beside medians and ratios");
}

}  // namespace

void add_table_command(Command& app, int& status) {
  const auto arguments = std::make_shared<TableArguments>();
  Command command = app.add_subcommand("table", "Print a table of the paper, or any pivot of the records");
  add_analysis_options(command, arguments->analysis);
  command
      .add_option("--paper", arguments->paper,
                  "The paper's table, measured, with the paper's own numbers: table1, table2 or table3")
      .type_name("NAME");
  command.add_flag("--stability", arguments->stability,
                   "For each family and method: certified share, worst width and true error, wrong answers, "
                   "failures, median time");
  command.add_flag(
      "--accuracy", arguments->accuracy,
      "For each method and tolerance: error, certified gap, time and what the next digit costs; then where "
      "each method stops getting better");
  command.add_flag(
      "--wrong", arguments->wrong,
      "Of two bodies (generator bodies): who is wrong, how often, at what price; by place and kind");
  add_pivot_options(command, *arguments);
  add_baseline_option(command, arguments->baselines);
  command.add_option("--format", arguments->format, "text, markdown, latex or csv").type_name("FORMAT");
  command.add_option("-o,--output", arguments->output, "Write to this file instead of standard output")
      .type_name("FILE");
  add_force_option(command, arguments->force);
  command.footer(
      "Examples:\n"
      "  raygauge table out/example2.h5 --paper table3\n"
      "  raygauge table out/example1.h5 --paper table1\n"
      "  raygauge table out/accuracy.h5 --accuracy\n"
      "  raygauge table out/bodies.h5 --wrong\n"
      "  raygauge table out/example2.h5 --rows n --cols N --value 'median ratio' --where "
      "'method==column_generation'\n"
      "  raygauge table out/example2.h5 --rows method --cols status --value count\n"
      "\n"
      "docs/analysis.md names every column, value and statistic.");
  command.callback([arguments, &status] { status = print_table(*arguments); });
}

}  // namespace raygauge::cli
