// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/experiment_file.h"

#include <limits>
#include <utility>

#include "cli/input/experiment_components.h"
#include "cli/input/toml_section.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

constexpr Range kPositiveInt{1, std::numeric_limits<int>::max()};
constexpr Range kNonNegativeInt{0, std::numeric_limits<int>::max()};
constexpr Range kSeed{0, 9e18};  // TOML integers end at 2^63 - 1
constexpr Range kTolerance{0, 1, true};
constexpr Range kStopWhenWithin{0, 1};
constexpr Range kMinRepetitions{6, std::numeric_limits<int>::max()};
constexpr Range kMinSeconds{0, 3600};
constexpr Range kTimeLimit{0, std::numeric_limits<double>::infinity(), true};

/// The name becomes that of the results file, so it must be fit for one.
void check_name(const toml::node& node, const std::string& name) {
  const bool fit = !name.empty() && name.front() != '.' && name.find('/') == std::string::npos &&
                   name.find_first_of("\n\t\\") == std::string::npos;
  if (fit) return;
  throw InvalidParameterError(place_of(node) + ": name must be fit for a file name, got '" + name + "'");
}

void read_root(const TomlSource& source, Experiment& experiment) {
  const TomlSection root(source, "", {"name", "description", "sweep", "generator", "method", "run"});
  root.text("name", experiment.name);
  root.text("description", experiment.description);
  root.with("name", [&](const toml::node& node, const std::string&) { check_name(node, experiment.name); });
}

void read_sweep(const TomlSource& source, Experiment& experiment) {
  const TomlSection sweep(
      source, "sweep",
      {"n", "N", "tolerance", "grid", "repetitions", "min_repetitions", "stop_when_within", "seed"});
  sweep.integers("n", kPositiveInt, experiment.n);
  sweep.integers("N", kPositiveInt, experiment.N);
  sweep.reals("tolerance", kTolerance, experiment.tolerance);
  sweep.choice("grid", {{"cartesian", GridMode::cartesian}, {"paired", GridMode::paired}}, experiment.grid);
  sweep.integer("repetitions", kPositiveInt, experiment.repetitions);
  sweep.integer("min_repetitions", kMinRepetitions, experiment.min_repetitions);
  sweep.real("stop_when_within", kStopWhenWithin, experiment.stop_when_within);
  sweep.integer("seed", kSeed, experiment.seed);
}

void read_run(const TomlSource& source, Experiment& experiment) {
  const TomlSection run(
      source, "run", {"threads", "timing", "pin_threads", "warmup", "min_seconds", "time_limit", "shuffle"});
  run.integer("threads", kNonNegativeInt, experiment.threads);
  run.choice("timing", {{"serial", TimingMode::serial}, {"parallel", TimingMode::parallel}},
             experiment.timing);
  run.boolean("pin_threads", experiment.pin_threads);
  run.integer("warmup", kNonNegativeInt, experiment.warmup);
  run.real("min_seconds", kMinSeconds, experiment.min_seconds);
  run.real("time_limit", kTimeLimit, experiment.time_limit);
  run.boolean("shuffle", experiment.shuffle);
}

/// What only the whole can show: lists that do not pair, cells that appear twice, limits that contradict.
void check_whole(const TomlSource& source, const Experiment& experiment) {
  try {
    validate(experiment);
    grid_of(experiment);
  } catch (const InvalidParameterError& error) {
    const toml::node* sweep = source.root.get("sweep");
    throw InvalidParameterError((sweep == nullptr ? source.path : place_of(*sweep)) + ": " + error.what());
  }
}

}  // namespace

namespace {

Experiment experiment_of(const TomlSource& source, const GeneratorRegistry& generators,
                         const MethodRegistry& methods) {
  Experiment experiment;
  experiment.text = source.text;
  read_root(source, experiment);
  read_sweep(source, experiment);
  read_run(source, experiment);
  experiment.generators = read_generators(source, generators);
  experiment.methods = read_methods(source, methods);
  check_whole(source, experiment);
  return experiment;
}

}  // namespace

Experiment read_experiment(const std::string& path, const std::vector<std::string>& overrides,
                           const GeneratorRegistry& generators, const MethodRegistry& methods) {
  return experiment_of(read_toml(path, overrides), generators, methods);
}

Experiment experiment_from_text(const std::string& text, const std::string& place,
                                const GeneratorRegistry& generators, const MethodRegistry& methods) {
  return experiment_of(toml_from_text(text, place), generators, methods);
}

}  // namespace raygauge::cli
