// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <future>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/between_query.h"
#include "cli/commands/commands.h"
#include "cli/commands/distance_query.h"
#include "cli/console/input_options.h"
#include "cli/input/input_file.h"
#include "cli/input/registries.h"
#include "cli/input/set_file.h"
#include "cli/input/set_source.h"
#include "cli/input/shapes.h"
#include "cli/input/streamed_source.h"
#include "cli/output/distance_report.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"
#include "results/schema/dataset.h"

namespace raygauge::cli {
namespace {

constexpr const char* kSources =
    "A and Q are each the convex hull of points: a text file with one point a line (commas or blanks, # "
    "comments), - for\n"
    "standard input, FILE.h5:/DATASET (rows are points), a mesh (.obj .off .stl .ply .dae .glb: its "
    "vertices), "
    "also "
    "compressed (.gz); or what "
    "a set file\n"
    "(.toml) describes: shape = \"ball\" and every parameter of that shape. Shapes, and what describes them "
    "(raygauge info\n"
    "tells more):\n";

constexpr const char* kExamples =
    "\n"
    "Examples:\n"
    "  raygauge distance A.csv Q.csv --tolerance 1e-9\n"
    "  raygauge distance points.h5:/A Q.obj --witness --json\n"
    "  raygauge distance capsule.toml ellipsoid.toml --method newton --tolerance 1e-12\n"
    "  raygauge distance capsule.toml ellipsoid.toml --between --signed\n"
    "  printf '3 1 0\\n4 -1 2\\n' | raygauge distance - Q.csv --method zheng_yamane\n"
    "\n"
    "Exit status: 0 answered, 2 bad usage or input, 3 a limit was reached (bounds are printed).";

std::string distance_footer() {
  std::string text = kSources;
  for (const Shape& shape : shapes()) {
    std::string names;
    for (const ShapeParameter& parameter : shape.parameters)
      names += (names.empty() ? "" : ", ") + parameter.name;
    text += fmt::format("  {:<21} {:<36} {}\n", shape.name, names, shape.description);
  }
  return text + kExamples;
}

const std::map<std::string, StopRule> kStopRules = {{"certified_gap", StopRule::certified_gap},
                                                    {"published_sigma", StopRule::published_sigma}};
const std::map<std::string, InstructionSet> kInstructionSets = {{"automatic", InstructionSet::automatic},
                                                                {"baseline", InstructionSet::baseline},
                                                                {"avx2", InstructionSet::avx2},
                                                                {"avx512", InstructionSet::avx512}};

template <class T>
std::vector<std::string> names_of(const std::map<std::string, T>& choices) {
  std::vector<std::string> names;
  for (const auto& entry : choices) names.push_back(entry.first);
  return names;
}

template <class T>
T chosen(const std::map<std::string, T>& choices, const std::string& kind, const std::string& name) {
  const auto found = choices.find(name);
  if (found == choices.end()) throw UnknownNameError(kind, name, names_of(choices));
  return found->second;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

struct DistanceArguments {
  std::string A;
  std::string Q;
  DistanceQuery query;
  std::string stop_rule = "certified_gap";
  std::string instruction_set = "automatic";
  PointFormat format{.header_option = "--skip-header"};
  bool json = false;
  bool between = false;
  bool is_signed = false;
  std::string metric;
};

void check_method(const std::string& name, const MethodRegistry& methods) {
  if (name != to_string(DistanceMethod::automatic)) methods.find(name);
}

/// What raygauge::validate says, by the name of the command's option. The rest of `query` decides on
/// the method later, and with it on the stop rule.
void check_options(DistanceOptions options) {
  options.stop_rule = StopRule::certified_gap;
  std::string problem = validate(options);
  if (problem.empty()) return;
  std::replace(problem.begin(), problem.begin() + static_cast<std::ptrdiff_t>(problem.find(' ')), '_', '-');
  throw InvalidParameterError("--" + problem);
}

/// Whether the source may be read beside another one: HDF5 has one reader at a time.
bool is_read_beside_others(const std::string& source) {
  return source != kStandardInput && !is_set_file(source) && !parse_dataset_reference(source);
}

/// Two files of points are read side by side.
Instance read_instance(const DistanceArguments& arguments) {
  const bool together = is_read_beside_others(arguments.A) && is_read_beside_others(arguments.Q);
  Notes notes, notes_of_Q;
  std::future<SetPointer> Q = std::async(together ? std::launch::async : std::launch::deferred, [&] {
    return read_set_source(arguments.Q, arguments.format, &notes_of_Q);
  });
  SetPointer A = read_set_source(arguments.A, arguments.format, &notes);
  Instance instance{std::move(A), Q.get(), std::nullopt};
  for (const std::string& note : notes_of_Q) add_note(note, notes);
  print_notes(notes);
  if (instance.A->dimension() == instance.Q->dimension()) return instance;
  const auto described = [](const std::string& source, const ConvexSet& set) {
    return input_name(source) + " has n = " + std::to_string(set.dimension());
  };
  throw DimensionMismatchError(
      "A and Q must have the same dimension: " + described(arguments.A, *instance.A) + ", " +
      described(arguments.Q, *instance.Q));
}

int exit_status(DistanceStatus status) {
  switch (status) {
    case DistanceStatus::optimal:
    case DistanceStatus::contains_origin:
    case DistanceStatus::unreachable:
      return kAnswered;
    default:
      return kLimitReached;
  }
}

// A and Q are two objects, in a metric of their own.
int run_between(const DistanceArguments& arguments, const MethodRegistry& methods) {
  Notes notes;
  const auto read = [&](const std::string& source) {
    return read_set_source(source, arguments.format, &notes);
  };
  const SetPointer A1 = read(arguments.A), A2 = read(arguments.Q);
  const SetPointer metric = arguments.metric.empty() ? nullptr : read(arguments.metric);
  print_notes(notes);
  const BetweenReport report = answer_between(arguments.query, arguments.is_signed, A1, A2, metric, methods);
  const std::string text = arguments.json ? json_text(between_json(report)) + "\n" : between_text(report);
  std::fputs(text.c_str(), stdout);
  return exit_status(report.status());
}

void check_sources(const DistanceArguments& arguments) {
  const std::string* sources[] = {&arguments.A, &arguments.Q, &arguments.metric};
  if (std::count_if(std::begin(sources), std::end(sources),
                    [](const std::string* source) { return *source == kStandardInput; }) > 1) {
    throw InvalidParameterError(std::string("only one of A") +
                                (arguments.metric.empty() ? "" : ", the metric") +
                                " and Q can come from standard input");
  }
  if (!arguments.between && (arguments.is_signed || !arguments.metric.empty())) {
    throw InvalidParameterError(std::string(arguments.is_signed ? "--signed" : "--metric") +
                                " is for the distance of two objects: add --between");
  }
}

int run(DistanceArguments arguments) {
  const MethodRegistry methods = all_methods();
  DistanceQuery& query = arguments.query;
  query.options.stop_rule = chosen(kStopRules, "stop rule", arguments.stop_rule);
  query.options.instruction_set = chosen(kInstructionSets, "instruction set", arguments.instruction_set);
  check_method(query.method, methods);
  check_options(query.options);
  check_sources(arguments);
  if (arguments.between) return run_between(arguments, methods);
  if (may_stream(query)) arguments.format.streamed_from = kStreamedFrom;
  const DistanceReport report = answer(query, read_instance(arguments), methods);
  const std::string text = arguments.json ? json_text(distance_json(report)) + "\n" : distance_text(report);
  std::fputs(text.c_str(), stdout);
  return exit_status(report.result.status);
}

void add_sets_and_output(Command& command, DistanceArguments& arguments) {
  command.add_option("A", arguments.A, "Set A, the object: a file of points or a set file")
      .required()
      .type_name("FILE");
  command.add_option("Q", arguments.Q, "Set Q, the gauge body, the origin in its interior: likewise")
      .required()
      .type_name("FILE");
  command
      .add_option("--tolerance", arguments.query.options.tolerance,
                  "Stop when upper - lower <= tolerance * upper; in (0, 1)")
      .type_name("EPS");
  command
      .add_option("--method", arguments.query.method,
                  "automatic (newton where Q is smooth, column_generation otherwise) or one of " +
                      joined(all_methods().names()) +
                      "; glpk stands for glpk_dual; any set: column_generation, "
                      "newton, zheng_yamane")
      .type_name("NAME");
  command.add_flag("--skip-header", arguments.format.skip_header,
                   "The first line of a text file of points is a heading, unless it begins with a number");
  command.add_flag("--witness", arguments.query.witness,
                   "Compute the contact point too; with --between the closest points, or those in contact");
  command.add_flag("--between", arguments.between,
                   "A and Q are two objects A1 and A2: the distance from one to the other");
  command
      .add_option("--metric", arguments.metric,
                  "With --between: the unit ball of the metric, a set like A; without it the Euclidean one")
      .type_name("FILE");
  command.add_flag("--signed", arguments.is_signed,
                   "With --between: objects that meet have minus their depth, the least way out");
  command.add_flag("--json", arguments.json, "Print one JSON object, numbers with 17 significant digits");
}

/// Returns those that are for the engine's methods alone.
std::vector<Option> add_limits_and_engine_options(Command& command, DistanceArguments& arguments) {
  DistanceOptions& options = arguments.query.options;
  const Option iterations = command
                                .add_option("--max-iterations", options.max_iterations,
                                            "Largest number of basis changes; 0: chosen from n")
                                .type_name("K");
  command.add_option("--time-limit", options.time_limit, "Seconds for the solve").type_name("SECONDS");
  const Option stop_rule =
      command
          .add_option("--stop-rule", arguments.stop_rule,
                      "certified_gap, or published_sigma (zheng_yamane only: |σ_k - 1| < EPS)")
          .type_name("RULE");
  const Option instruction_set = command
                                     .add_option("--instruction-set", arguments.instruction_set,
                                                 "Vector kernels: " + joined(names_of(kInstructionSets)))
                                     .type_name("NAME");
  const Option threads =
      command
          .add_option("--threads", options.threads,
                      "Threads of the solve; column_generation shares its passes over large point sets")
          .type_name("K");
  return {iterations, stop_rule, instruction_set, threads};
}

}  // namespace

void add_distance_command(Command& app, int& status) {
  const auto arguments = std::make_shared<DistanceArguments>();
  Command command = app.add_subcommand("distance", "The distance of one set A in the gauge of one set Q");
  add_sets_and_output(command, *arguments);
  const std::vector<Option> of_engine = add_limits_and_engine_options(command, *arguments);
  add_max_input_option(command);
  command.footer(distance_footer());
  command.callback([=, &status] {
    arguments->query.engine_options_set = std::any_of(
        of_engine.begin(), of_engine.end(), [](const Option& option) { return option.count() > 0; });
    status = run(*arguments);
  });
}

}  // namespace raygauge::cli
