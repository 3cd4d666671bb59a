// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep/experiment.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// More cells than any sweep finishes; a slip in a range ends here, not in memory.
constexpr double kMaxCells = 1e6;

std::string text_of(double value) { return to_string(ParameterValue(value)); }

void require(bool holds, const std::string& message) {
  if (!holds) throw InvalidParameterError(message);
}

void require_at_least(const std::string& key, int value, int minimum) {
  require(value >= minimum,
          key + " must be at least " + std::to_string(minimum) + ", got " + std::to_string(value));
}

void validate_sizes(const std::vector<int>& dimensions, const std::vector<int>& counts) {
  for (const int n : dimensions) require_at_least("n", n, 1);
  for (const int N : counts) require_at_least("N", N, 1);
}

void validate_axes(const Experiment& experiment) {
  validate_sizes(experiment.n, experiment.N);
  for (const GeneratorSpec& generator : experiment.generators) validate_sizes(generator.n, generator.N);
  for (const double tolerance : experiment.tolerance) {
    require(tolerance > 0 && tolerance < 1, "tolerance must lie in (0, 1), got " + text_of(tolerance));
  }
}

/// Five values have no 95 % interval of their median: see order_statistic_rank().
constexpr int kFewestForAnInterval = 6;

void validate_repetitions(const Experiment& experiment) {
  require_at_least("repetitions", experiment.repetitions, 1);
  require_at_least("min_repetitions", experiment.min_repetitions, kFewestForAnInterval);
  const double within = experiment.stop_when_within;
  require(within >= 0 && within <= 1, "stop_when_within must lie in [0, 1], got " + text_of(within));
  if (within > 0) {
    require(experiment.repetitions >= experiment.min_repetitions,
            "stop_when_within needs repetitions of at least min_repetitions, " +
                std::to_string(experiment.min_repetitions) + ", got " +
                std::to_string(experiment.repetitions));
  }
}

void validate_run(const Experiment& experiment) {
  require_at_least("warmup", experiment.warmup, 0);
  require_at_least("threads", experiment.threads, 0);
  require(experiment.min_seconds >= 0 && std::isfinite(experiment.min_seconds),
          "min_seconds must be finite and not negative, got " + text_of(experiment.min_seconds));
  require(experiment.time_limit > 0, "time_limit must be positive, got " + text_of(experiment.time_limit));
}

/// The axes n and N of a generator's part of the grid.
const std::vector<int>& dimensions_of(const Experiment& experiment, const GeneratorSpec& generator) {
  return generator.n.empty() ? experiment.n : generator.n;
}
const std::vector<int>& counts_of(const Experiment& experiment, const GeneratorSpec& generator) {
  return generator.N.empty() ? experiment.N : generator.N;
}

void require_affordable(const Experiment& experiment) {
  double cells = 0;
  for (const GeneratorSpec& generator : experiment.generators) {
    const auto dimensions = static_cast<double>(dimensions_of(experiment, generator).size());
    const auto counts = static_cast<double>(counts_of(experiment, generator).size());
    const double sizes = experiment.grid == GridMode::paired ? dimensions : dimensions * counts;
    cells += sizes * static_cast<double>(experiment.tolerance.size());
  }
  require(cells <= kMaxCells,
          "the grid has " + text_of(cells) + " cells, more than " + text_of(kMaxCells) + " are refused");
}

/// The pairs (n, N) of a generator's part of the grid, in its order.
std::vector<std::pair<int, int>> sizes_of(const Experiment& experiment, const GeneratorSpec& generator) {
  const std::vector<int>& dimensions = dimensions_of(experiment, generator);
  const std::vector<int>& counts = counts_of(experiment, generator);
  std::vector<std::pair<int, int>> sizes;
  if (experiment.grid == GridMode::paired) {
    require(dimensions.size() == counts.size(), "a paired grid needs lists n and N of one length, got " +
                                                    std::to_string(dimensions.size()) + " and " +
                                                    std::to_string(counts.size()));
    for (std::size_t i = 0; i < dimensions.size(); ++i) sizes.emplace_back(dimensions[i], counts[i]);
    return sizes;
  }
  for (const int n : dimensions) {
    for (const int N : counts) sizes.emplace_back(n, N);
  }
  return sizes;
}

/// The first value that appears a second time; nothing where all differ.
template <class T>
std::optional<T> repeated_value(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  const auto twice = std::adjacent_find(values.begin(), values.end());
  return twice == values.end() ? std::nullopt : std::optional<T>(*twice);
}

void require_distinct(const std::vector<std::pair<int, int>>& sizes, const std::vector<double>& tolerances) {
  const auto size = repeated_value(sizes);
  const auto tolerance = repeated_value(tolerances);
  if (sizes.empty() || tolerances.empty() || (!size && !tolerance)) return;
  const auto [n, N] = size.value_or(sizes.front());
  throw InvalidParameterError("the cell n = " + std::to_string(n) + ", N = " + std::to_string(N) +
                              ", tolerance = " + text_of(tolerance.value_or(tolerances.front())) +
                              " appears twice in the grid");
}

}  // namespace

bool Experiment::pins() const {
  return pin_threads && std::none_of(methods.begin(), methods.end(), [](const ComponentSpec& method) {
           return method.parameters.count("threads") != 0 &&
                  integer_parameter(method.parameters, "threads") > 1;
         });
}

const std::string& label_of(const ComponentSpec& component) {
  return component.label.empty() ? component.name : component.label;
}

void validate(const Experiment& experiment) {
  validate_axes(experiment);
  validate_repetitions(experiment);
  validate_run(experiment);
  require(!experiment.generators.empty(), "the experiment names no generator");
  require(!experiment.methods.empty(), "the experiment names no method");
  std::set<std::string> labels;
  for (const ComponentSpec& method : experiment.methods) {
    require(labels.insert(label_of(method)).second,
            "two methods are labelled '" + label_of(method) + "'; give one of them another label");
  }
}

std::vector<Cell> grid_of(const Experiment& experiment) {
  require_affordable(experiment);
  std::vector<Cell> cells;
  for (std::size_t generator = 0; generator < experiment.generators.size(); ++generator) {
    const auto sizes = sizes_of(experiment, experiment.generators[generator]);
    require_distinct(sizes, experiment.tolerance);
    for (const auto& [n, N] : sizes) {
      for (const double tolerance : experiment.tolerance) {
        cells.push_back({cells.size(), generator, n, N, tolerance});
      }
    }
  }
  require(!cells.empty(),
          "the grid has no cells: n, N, tolerance and generator need at least one value each");
  return cells;
}

}  // namespace raygauge
