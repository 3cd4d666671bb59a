// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/dry_run.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/output/terminal.h"
#include "engine/numerics/number_text.h"
#include "engine/sweep/makespan.h"
#include "results/exceptions.h"
#include "results/run/identity.h"
#include "results/run/results_file.h"
#include "results/text/language.h"

namespace raygauge::cli {
namespace {

/// What dealing out a piece takes: a one-sided operation over a network (docs/scaling.md).
constexpr double kCounterSeconds = 1e-5;

/// What `raygauge merge` writes (docs/scaling.md).
constexpr double kMergedRecordsPerSecond = 5e5;

const std::string& value_text(const std::string& value) { return value; }
std::string value_text(double value) {
  constexpr int kDigits = 6;
  return rounded_text(value, kDigits);
}

std::string value_text(const ComponentSpec& component) {
  std::string text = label_of(component);
  if (text != component.name) text += " = " + component.name;
  const std::string parameters = to_string(component.parameters);
  return parameters.empty() ? text : text + " {" + parameters + "}";
}

/// The most entries of a list that are printed.
constexpr std::size_t kMostEntries = 12;

/// The first entries, and how many values there are if that is not all.
std::string joined(const std::vector<std::string>& entries, const char* separator, std::size_t values) {
  std::string text;
  const std::size_t shown = entries.size() > kMostEntries ? kMostEntries - 1 : entries.size();
  for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : separator) + entries[i];
  if (shown < entries.size()) text += separator + std::string("… (") + std::to_string(values) + " values)";
  return text;
}

template <class T>
std::string list_text(const std::vector<T>& values, const char* separator) {
  std::vector<std::string> entries;
  for (const T& value : values) entries.push_back(value_text(value));
  return joined(entries, separator, entries.size());
}

/// "3 5 … 10" or "200 … 2000 (step 200)": evenly spaced values, four or more, as a range.
std::string list_text(const std::vector<int>& values, const char* separator) {
  constexpr std::size_t kFewest = 4;
  std::vector<std::string> entries;
  for (std::size_t first = 0; first < values.size();) {
    std::size_t last = first + 1;
    const auto step = [&](std::size_t i) { return values[i] - values[i - 1]; };
    while (last + 1 < values.size() && step(last + 1) == step(first + 1)) ++last;
    if (last - first + 1 < kFewest || last >= values.size()) {
      entries.push_back(std::to_string(values[first++]));
      continue;
    }
    entries.push_back(std::to_string(values[first]) + " … " + std::to_string(values[last]));
    if (step(last) != 1) entries.back() += " (step " + std::to_string(step(last)) + ")";
    first = last + 1;
  }
  return joined(entries, separator, values.size());
}

/// Generators that differ in their parameters' values alone, such as one [[generator]] with lists makes.
class Family {
 public:
  explicit Family(const GeneratorSpec& first) : first_(first) { add(first); }

  bool may_hold(const GeneratorSpec& other) const {
    return other.name == first_.name && other.n == first_.n && other.N == first_.N;
  }

  void add(const GeneratorSpec& spec) {
    ++members_;
    for (const auto& [name, value] : spec.parameters) {
      Values& values = parameters_[name];
      if (values.seen.insert(to_string(value)).second) values.in_order.push_back(to_string(value));
    }
  }

  /// Whether the members are all combinations of their parameters' values, so that text() tells them all.
  bool is_whole() const {
    std::size_t combinations = 1;
    for (const auto& entry : parameters_) combinations *= entry.second.in_order.size();
    return combinations == members_;
  }

  /// "hard_vertex {body=cube,simplex lambda=1,3} n = 2 3"
  std::string text() const {
    std::string parameters;
    for (const auto& [name, values] : parameters_) {
      parameters += (parameters.empty() ? "" : " ") + name + "=" + list_text(values.in_order, ",");
    }
    std::string text = first_.name;
    if (!parameters.empty()) text += " {" + parameters + "}";
    if (!first_.n.empty()) text += " n = " + list_text(first_.n, " ");
    if (!first_.N.empty()) text += " N = " + list_text(first_.N, " ");
    return text;
  }

 private:
  struct Values {
    std::vector<std::string> in_order;
    std::set<std::string> seen;
  };
  const GeneratorSpec& first_;
  std::size_t members_ = 0;
  std::map<std::string, Values> parameters_;
};

/// The end of the longest family of generators from `first` on.
std::size_t end_of_family(const std::vector<GeneratorSpec>& generators, std::size_t first) {
  Family family(generators[first]);
  std::size_t end = first + 1;
  for (std::size_t i = end; i < generators.size() && family.may_hold(generators[i]); ++i) {
    family.add(generators[i]);
    if (family.is_whole()) end = i + 1;
  }
  return end;
}

std::string grid_line(const std::string& heading, const std::string& text) {
  constexpr std::size_t kWidth = 13;
  return "  " + heading + std::string(kWidth - heading.size(), ' ') + language::printable(text) + "\n";
}

/// A line for each family.
std::string generator_lines(const std::vector<GeneratorSpec>& generators) {
  std::string lines;
  for (std::size_t first = 0; first < generators.size();) {
    const std::size_t end = end_of_family(generators, first);
    Family family(generators[first]);
    for (std::size_t i = first + 1; i < end; ++i) family.add(generators[i]);
    lines += grid_line(first == 0 ? "generators" : "", family.text());
    first = end;
  }
  return lines;
}

/// Separated by commas, on as many lines as it takes.
std::string method_lines(const std::vector<ComponentSpec>& methods) {
  constexpr std::size_t kWidth = 90;
  std::string lines;
  std::string line;
  for (const ComponentSpec& method : methods) {
    const std::string text = value_text(method) + (&method == &methods.back() ? "" : ",");
    if (!line.empty() && line.size() + 1 + text.size() > kWidth) {
      lines += grid_line(lines.empty() ? "methods" : "", line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + text;
  }
  return lines + grid_line(lines.empty() ? "methods" : "", line);
}

/// "20 a cell", or how many it may become.
std::string repetitions_text(const Experiment& experiment) {
  std::string most = std::to_string(experiment.repetitions) + " a cell";
  if (experiment.stop_when_within == 0) return most;
  return std::to_string(experiment.min_repetitions) + " to " + most +
         ", until the medians are known within " + value_text(100 * experiment.stop_when_within) + " %";
}

std::string two_digits(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

std::string bytes_text(double bytes) {
  constexpr double kStep = 1024;
  constexpr std::array<const char*, 4> kUnits = {"KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  bytes /= kStep;
  while (bytes >= kStep && unit + 1 < kUnits.size()) {
    bytes /= kStep;
    ++unit;
  }
  return rounded_text(bytes, 2) + " " + kUnits.at(unit);
}

/// What the largest cell needs, and all threads with such cells at once.
std::string memory_text(const SweepEstimate& estimate) {
  std::string text = "about " + bytes_text(estimate.largest_bytes) +
                     " for the largest cell (n = " + std::to_string(estimate.largest.n) +
                     ", N = " + std::to_string(estimate.largest.N) + ")";
  if (estimate.threads == 1) return text;
  return text + ", " + bytes_text(estimate.threads * estimate.largest_bytes) + " for " +
         std::to_string(estimate.threads) + " at once";
}

/// What keeps so many workers from being busy all the time.
std::string limit_text(const Experiment& experiment, const Makespan& makespan, std::uint64_t workers) {
  constexpr double kGood = 0.9;
  const std::string pieces = std::to_string(makespan.pieces) + " pieces";
  if (makespan.efficiency >= kGood) return "none yet: " + pieces + " keep all ranks busy";
  if (makespan.counter_seconds > makespan.seconds / 2) return "the counter that deals out " + pieces;
  if (makespan.pieces < workers) return pieces + " are fewer than the ranks";
  return "the longest of " + pieces + " takes " + duration_text(makespan.longest) +
         (experiment.stop_when_within > 0 ? " (adaptive cells are not split)" : "");
}

}  // namespace

std::string dry_run_text(const Experiment& experiment, const SweepEstimate& estimate) {
  const bool paired = experiment.grid == GridMode::paired;
  const bool serial = experiment.timing == TimingMode::serial;
  const std::string at_most = experiment.stop_when_within > 0 ? "at most " : "";
  std::string text = language::printable(experiment.name);
  if (!experiment.description.empty()) text += ": " + language::printable(experiment.description);
  text += "\n";
  text += grid_line("n", list_text(experiment.n, " "));
  text += grid_line("N", list_text(experiment.N, " ") + (paired ? "  (paired with n)" : ""));
  text += grid_line("tolerance", list_text(experiment.tolerance, " "));
  text += generator_lines(experiment.generators);
  text += method_lines(experiment.methods);
  text += grid_line("cells", std::to_string(estimate.cells));
  text += grid_line("instances", at_most + std::to_string(estimate.instances) + " (" +
                                     repetitions_text(experiment) + ", seed " +
                                     std::to_string(experiment.seed) + ")");
  text += grid_line("solves", at_most + std::to_string(estimate.records) + " timed, each limited to " +
                                  duration_text(experiment.time_limit));
  text += grid_line("timing", std::string(serial ? "serial" : "parallel") + ", " +
                                  std::to_string(estimate.threads) +
                                  (estimate.threads == 1 ? " thread" : " threads"));
  if (estimate.largest_bytes > 0) text += grid_line("memory", memory_text(estimate));
  text += grid_line("estimate", at_most + "about " + duration_text(estimate.seconds) + ", from probing " +
                                    std::to_string(estimate.probed_cells) + " of the cells for " +
                                    duration_text(estimate.probing_seconds));
  return text;
}

std::string ranks_text(const Experiment& experiment, const std::vector<double>& cell_seconds, int ranks,
                       const std::string& source) {
  const auto workers = static_cast<std::uint64_t>(ranks);
  const Makespan together = simulate_ranks(experiment, cell_seconds, workers, kCounterSeconds);
  const Makespan shards = simulate_shards(experiment, cell_seconds, ranks);
  const double records = static_cast<double>(cell_seconds.size()) * experiment.repetitions *
                         static_cast<double>(experiment.methods.size());
  const auto line = [](const std::string& heading, const Makespan& makespan) {
    return grid_line(heading, "about " + duration_text(makespan.seconds) + ", efficiency " +
                                  two_digits(makespan.efficiency));
  };
  return line("ranks", together).insert(15, std::to_string(ranks) + " of one thread, by " + source + ": ") +
         line("shards", shards).insert(15, std::to_string(ranks) + ": ") +
         grid_line("limit", limit_text(experiment, together, workers)) +
         grid_line("merge", "about " + duration_text(records / kMergedRecordsPerSecond));
}

std::vector<double> measured_cell_seconds(const Experiment& experiment, const std::string& path) {
  const ResultsFile results = read_results(path);
  const std::vector<Cell> grid = grid_of(experiment);
  const std::string difference =
      identity_difference(results.provenance.identity, experiment_identity(experiment));
  if (!difference.empty()) throw OtherExperimentError(path + ": holds another experiment: " + difference);
  if (!results.finished()) throw ResultsError(path + ": is not finished, so that times of cells are missing");
  std::vector<double> seconds(grid.size(), 0.0);
  double timed = 0;
  std::map<std::pair<int, int>, std::pair<double, double>> spans;  // of each thread: first start, last end
  for (const Record& record : results.records) {
    const double own = record.load_seconds + record.seconds * record.inner_repetitions;
    seconds.at(record.cell) += own;
    timed += own;
    const double end = record.started_at + own;
    auto& span = spans.try_emplace({record.session, record.thread}, record.started_at, end).first->second;
    span = {std::min(span.first, record.started_at), std::max(span.second, end)};
  }
  double busy = 0;
  for (const auto& [thread, span] : spans) busy += span.second - span.first;
  // What is not timed, instances and warm-up, takes its part of every cell.
  for (double& cell : seconds) cell *= std::max(1.0, busy / timed);
  return seconds;
}

}  // namespace raygauge::cli
