// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Overrides as --set takes them, one a line, upon an experiment that is right: what is accepted is an
// experiment whose stored text, read again, is the same one.
#include <sstream>
#include <string>
#include <vector>

#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz::experiment_override {
namespace {

constexpr std::string_view kExperiment = R"(name = "base"
[sweep]
n = [2, 3]
N = {from = 10, to = 40, factor = 2.0}
[[generator]]
name = "example2"
separation = [1.0, 2.0]
[[method]]
name = "column_generation"
[[method]]
name = "glpk_dual"
label = "dual"
[run]
time_limit = 5
)";

std::vector<std::string> lines_of(std::string_view text) {
  std::istringstream stream{std::string(text)};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void expect_same(const Experiment& a, const Experiment& b) {
  const auto components = [](const auto& specs) {
    std::string text;
    for (const ComponentSpec& spec : specs) {
      text.append(spec.name + '|' + spec.label + '|' + to_string(spec.parameters) + '\n');
    }
    return text;
  };
  require(a.name == b.name && a.description == b.description && a.n == b.n && a.N == b.N &&
              a.tolerance == b.tolerance && a.seed == b.seed && a.repetitions == b.repetitions &&
              a.time_limit == b.time_limit && components(a.generators) == components(b.generators) &&
              components(a.methods) == components(b.methods),
          "the stored text of an overridden experiment is that experiment");
}

}  // namespace
}  // namespace raygauge::fuzz::experiment_override

namespace raygauge::fuzz {

void check_override(std::string_view input) {
  static const GeneratorRegistry generators = cli::all_generators();
  static const MethodRegistry methods = cli::all_methods();
  static const ScratchFile base(".base.toml"), stored(".stored.toml");
  base.write(experiment_override::kExperiment);
  const std::vector<std::string> overrides = experiment_override::lines_of(input);
  std::string text;
  Experiment experiment;
  expect_success_or_error([&] {
    experiment = cli::read_experiment(base.path(), overrides, generators, methods);
    text = experiment.text;
  });
  if (text.empty()) return;
  stored.write(text);
  experiment_override::expect_same(experiment, cli::read_experiment(stored.path(), {}, generators, methods));
}

}  // namespace raygauge::fuzz
