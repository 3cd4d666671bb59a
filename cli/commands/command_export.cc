// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string_view>

#include "analysis/data/parameter_columns.h"
#include "cli/commands/analysis_options.h"
#include "cli/commands/commands.h"
#include "cli/console/interrupt.h"
#include "cli/input/registries.h"
#include "cli/output/output_file.h"
#include "cli/output/refutation_report.h"
#include "raygauge/exceptions.h"
#include "results/journal/csv.h"
#include "results/text/words.h"
#include "scene/file/scene_file.h"

namespace raygauge::cli {
namespace {

struct ExportArguments {
  AnalysisArguments analysis;
  std::string csv, refutations;
  bool tidy = false;
  bool contacts = false, steps = false, simulations = false, answers = false;
  bool force = false;
};

/// Of a simulation, where its bodies are; else the answers.
std::string scene_table(const ExportArguments& arguments, const SceneFile& file) {
  std::vector<std::string> bodies;
  for (const SceneBodyRow& body : file.bodies) bodies.push_back(body.name);
  if (!file.simulation) {
    for (const auto& [option, given] :
         {GivenOption{"--contacts", arguments.contacts}, GivenOption{"--steps", arguments.steps},
          GivenOption{"--simulations", arguments.simulations}}) {
      if (given)
        throw InvalidParameterError(arguments.analysis.files.front() + ": holds no simulation, for which " +
                                    option + " is");
    }
  }
  if (!file.simulation || arguments.answers) return scene_csv(file);
  if (arguments.contacts) return contacts_csv(*file.simulation, bodies);
  if (arguments.simulations) return simulations_csv(*file.simulation);
  return arguments.steps ? steps_csv(*file.simulation) : states_csv(*file.simulation, bodies);
}

/// A scene's records; they have columns of their own, and no filter.
bool exported_scene(const ExportArguments& arguments) {
  const std::vector<std::string>& files = arguments.analysis.files;
  if (files.size() != 1 || !is_scene_file(files.front())) return false;
  refuse_options_of_scene(arguments.analysis, {{"--tidy", arguments.tidy}});
  const Output output =
      output_of(arguments.csv, OutputKind::text, {".csv"}, arguments.analysis, arguments.force);
  write_to(output, scene_table(arguments, read_scene(arguments.analysis)));
  return true;
}

/// A signal came: a file that is not whole is taken back.
struct Interrupted {};

/// Proofs that answers about two bodies are wrong, and how many of them could be proven.
int export_refutations(const ExportArguments& arguments) {
  for (const auto& [option, given] :
       {GivenOption{"--csv", !arguments.csv.empty()}, GivenOption{"--tidy", arguments.tidy},
        GivenOption{"--contacts", arguments.contacts}, GivenOption{"--steps", arguments.steps},
        GivenOption{"--simulations", arguments.simulations}, GivenOption{"--answers", arguments.answers}}) {
    if (given) throw InvalidParameterError("export: --refutations or " + option + ", not both");
  }
  if (is_scene_file(arguments.analysis.files.front()))
    refuse_options_of_scene(arguments.analysis, {{"--refutations", true}});
  const Filter filter = filter_of(arguments.analysis);
  const Output output =
      output_of(arguments.refutations, OutputKind::text, {".jsonl"}, arguments.analysis, arguments.force);
  const std::vector<Record> records = read_files(arguments.analysis).records;
  RefutationCount count;
  const InterruptGuard guard(nullptr);
  const auto unless_interrupted = [](const ByteSink& put) {
    return [&put](std::string_view line) {
      if (InterruptGuard::signal() != 0) throw Interrupted();
      put(line);
    };
  };
  try {
    write_to(output, [&](const ByteSink& put) {
      count = put_refutations(records, filter, all_generators(), unless_interrupted(put));
    });
  } catch (const Interrupted&) {
    std::fputs("interrupted\n", stderr);
    return interrupted_status();
  }
  std::fprintf(stderr, "note: %s, %zu of them refuted\n", counted(count.wrong, "wrong answer").c_str(),
               count.refuted);
  if (!count.open.empty()) std::fprintf(stderr, "note: not refuted: %s\n", count.open.c_str());
  return kAnswered;
}

int export_records(const ExportArguments& arguments) {
  if (!arguments.refutations.empty()) return export_refutations(arguments);
  if (arguments.csv.empty())
    throw InvalidParameterError("export: give --csv OUT.csv or --refutations OUT.jsonl");
  if (static_cast<int>(arguments.contacts) + static_cast<int>(arguments.steps) +
          static_cast<int>(arguments.simulations) + static_cast<int>(arguments.answers) >
      1)
    throw InvalidParameterError(
        "export: --contacts, --steps, --simulations and --answers name one table each; give one");
  if (exported_scene(arguments)) return kAnswered;
  if (arguments.contacts || arguments.steps || arguments.simulations || arguments.answers)
    throw InvalidParameterError(
        "export: --contacts, --steps, --simulations and --answers are for the file of one scene");
  const Filter filter = filter_of(arguments.analysis);
  const Output output =
      output_of(arguments.csv, OutputKind::text, {".csv"}, arguments.analysis, arguments.force);
  const std::vector<Record> records = filtered(read_files(arguments.analysis).records, filter);
  if (records.empty() && !filter.expression().empty())
    throw EmptySetError("no record passes the filter '" + filter.expression() + "'; nothing was written");
  write_to(output, arguments.tidy ? tidy_csv(records) : csv_text(records));
  return kAnswered;
}

}  // namespace

void add_export_command(Command& app, int& status) {
  const auto arguments = std::make_shared<ExportArguments>();
  Command command =
      app.add_subcommand("export", "Write the records of results files as CSV, or proofs of wrong answers");
  add_analysis_options(command, arguments->analysis);
  command
      .add_option(
          "--csv", arguments->csv,
          "File to write, - for standard output: one line a record, the columns of docs/file-format.md")
      .type_name("OUT.csv");
  command
      .add_option("--refutations", arguments->refutations,
                  "Instead: of each wrong answer about two bodies (generator bodies) a line of JSON, with "
                  "the bodies and "
                  "a proof that docs/examples/check_refutations.py checks")
      .type_name("OUT.jsonl");
  command.add_flag("--tidy", arguments->tidy,
                   "Add a column for each parameter of a generator or method, as separation");
  command.add_flag("--contacts", arguments->contacts,
                   "Of a simulation: a line a contact, in place of one a body and instant");
  command.add_flag("--steps", arguments->steps, "Of a simulation: a line a step");
  command.add_flag("--simulations", arguments->simulations,
                   "Of a simulation: a line each step and tolerance: what it cost and how accurate it was");
  command.add_flag("--answers", arguments->answers, "Of a scene: the answers to its queries");
  add_force_option(command, arguments->force);
  command.footer(
      "Examples:\n"
      "  raygauge export out/example2.h5 --csv out/example2.csv --tidy\n"
      "  raygauge export out/example2.h5 --csv out/small.csv --where 'n<=4 && agrees'\n"
      "  raygauge export out/bodies.h5 --refutations out/wrong.jsonl --where 'method==fcl_libccd'");
  command.callback([arguments, &status] { status = export_records(*arguments); });
}

}  // namespace raygauge::cli
