// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What do the numbers cost that were found by measurement? Each threshold of the engine (its tuning.h files)
// is varied, and what it bounds is timed with each value, all taking turns.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/program.h"
#include "bench/timed_medians.h"
#include "bench/tuning_rows.h"

namespace raygauge::bench {
namespace {

struct Settings {
  std::vector<std::string> only;
  int rounds = 9;
  std::vector<double> values;
  std::vector<std::string> cells;
  std::string variant = "random", method = "column_generation";
};

// "50:100": n and N.
Cell cell_of(const std::string& text) {
  Cell cell;
  char colon = 0;
  std::istringstream in(text);
  if (!(in >> cell.n >> colon >> cell.N) || colon != ':' || in.get() != EOF || cell.n < 1 || cell.N < 1)
    throw std::invalid_argument("--cells " + text + ": n:N expected");
  return cell;
}

// A row with what the settings say in place of its own.
TuningRow as_asked(TuningRow row, const Settings& settings) {
  if (!settings.values.empty()) row.values = settings.values;
  if (settings.cells.empty()) return row;
  std::vector<Cell> cells;
  row.on = settings.variant;
  for (const std::string& text : settings.cells) {
    cells.push_back(cell_of(text));
    row.on += " " + text;
  }
  row.workload = solves(settings.method, cells, settings.variant);
  return row;
}

// So many calls in a row take some milliseconds.
int repeats_of(const Call& call) {
  constexpr double kSeconds = 5e-3;
  call();
  const double seconds = seconds_of(call, Clock::processor);
  return static_cast<int>(std::clamp(kSeconds / seconds, 1.0, 1000.0));
}

// Medians over that with the value which stands, in the order of the values.
void print_row(const TuningRow& row, int rounds) {
  std::vector<double> values = row.values;
  values.push_back(row.threshold.measured());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<Call> calls;
  for (const double value : values) {
    row.threshold.change(value);
    calls.emplace_back([&row, value, call = row.workload()] {
      row.threshold.change(value);
      call();
    });
  }
  const auto own = static_cast<std::size_t>(
      std::find(values.begin(), values.end(), row.threshold.measured()) - values.begin());
  const std::vector<double> medians = microseconds_in_turn(calls, rounds, repeats_of(calls[own]), row.clock);
  row.threshold.restore();
  std::printf("%-24s %-42s", row.threshold.name().c_str(), row.on.c_str());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i == own) {
      std::printf("  [%g]", values[i]);
    } else {
      std::printf("  %g: %.2f", values[i], medians[i] / medians[own]);
    }
  }
  std::printf("  %.3g ms\n", 1e-3 * medians[own]);
  std::fflush(stdout);
}

void options(CLI::App& app, Settings& settings) {
  std::vector<std::string> names;
  for (const TunedMethod& method : tuned_methods()) {
    for (const TuningRow& row : method.rows) names.push_back(row.threshold.name());
  }
  app.add_option("--only", settings.only, "thresholds, separated by commas; none: all")
      ->delimiter(',')
      ->check([names](const std::string& name) {
        const bool known = std::find(names.begin(), names.end(), name) != names.end();
        return known ? std::string() : name + ": no tuning.h of the engine has it";
      });
  app.add_option("--rounds", settings.rounds, "calls that a median is of")->check(CLI::PositiveNumber);
  app.add_option("--values", settings.values, "in place of those tried, separated by commas")->delimiter(',');
  app.add_option("--cells", settings.cells,
                 "n:N, separated by commas: solves of these in place of what a row times")
      ->delimiter(',');
  app.add_option("--variant", settings.variant, "kind of these instances");
  app.add_option("--method", settings.method, "of these solves");
}

void run(const Settings& settings) {
  std::printf("median time over that with the value that stands [in brackets, with its time]\n");
  for (const TunedMethod& method : tuned_methods()) {
    bool named = false;
    for (const TuningRow& row : method.rows) {
      const auto& only = settings.only;
      if (!only.empty() && std::find(only.begin(), only.end(), row.threshold.name()) == only.end()) continue;
      if (!named) std::printf("\n%s\n", method.name.c_str());
      named = true;
      print_row(as_asked(row, settings), settings.rounds);
    }
  }
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  using namespace raygauge::bench;
  return run_with_options<Settings>("raygauge_tuning",
                                    "Varies each number of the engine that was found by measurement.",
                                    options, run, argc, argv);
}
