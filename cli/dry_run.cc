// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/dry_run.h"

#include <vector>

#include "cli/terminal.h"

namespace raygauge::cli {
namespace {

std::string value_text(int value) { return std::to_string(value); }
std::string value_text(double value) { return to_string(ParameterValue(value)); }

std::string value_text(const ComponentSpec& component) {
  std::string text = label_of(component);
  if (text != component.name) text += " = " + component.name;
  const std::string parameters = to_string(component.parameters);
  return parameters.empty() ? text : text + " {" + parameters + "}";
}

std::string value_text(const GeneratorSpec& generator);

template <class T>
std::string list_text(const std::vector<T>& values, const char* separator) {
  std::string text;
  for (const T& value : values) {
    if (!text.empty()) text += separator;
    text += value_text(value);
  }
  return text;
}

std::string value_text(const GeneratorSpec& generator) {
  std::string text = value_text(static_cast<const ComponentSpec&>(generator));
  if (!generator.n.empty()) text += " n = " + list_text(generator.n, " ");
  if (!generator.N.empty()) text += " N = " + list_text(generator.N, " ");
  return text;
}

std::string grid_line(const std::string& heading, const std::string& text) {
  constexpr std::size_t kWidth = 13;
  return "  " + heading + std::string(kWidth - heading.size(), ' ') + text + "\n";
}

}  // namespace

std::string dry_run_text(const Experiment& experiment, const SweepEstimate& estimate) {
  const bool paired = experiment.grid == GridMode::paired;
  const bool serial = experiment.timing == TimingMode::serial;
  std::string text = experiment.name;
  if (!experiment.description.empty()) text += ": " + experiment.description;
  text += "\n";
  text += grid_line("n", list_text(experiment.n, " "));
  text += grid_line("N", list_text(experiment.N, " ") + (paired ? "  (paired with n)" : ""));
  text += grid_line("tolerance", list_text(experiment.tolerance, " "));
  text += grid_line("generators", list_text(experiment.generators, ", "));
  text += grid_line("methods", list_text(experiment.methods, ", "));
  text += grid_line("cells", std::to_string(estimate.cells));
  text += grid_line("instances", std::to_string(estimate.instances) + " (" +
                                     std::to_string(experiment.repetitions) + " a cell, seed " +
                                     std::to_string(experiment.seed) + ")");
  text += grid_line("solves", std::to_string(estimate.records) + " timed, each limited to " +
                                  duration_text(experiment.time_limit));
  text += grid_line("timing", std::string(serial ? "serial" : "parallel") + ", " +
                                  std::to_string(estimate.threads) +
                                  (estimate.threads == 1 ? " thread" : " threads"));
  text += grid_line("estimate", "about " + duration_text(estimate.seconds) + ", from probing " +
                                    std::to_string(estimate.probed_cells) + " of the cells for " +
                                    duration_text(estimate.probing_seconds));
  return text;
}

}  // namespace raygauge::cli
