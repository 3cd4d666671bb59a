// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/calibration.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "engine/sweep/cell_runner.h"
#include "engine/sweep/order_statistics.h"
#include "engine/sweep/repetitions.h"
#include "engine/sweep/schedule.h"
#include "engine/threads/team.h"

namespace raygauge {
namespace {

/// Enough for an interval of the median, even if the sweep is short.
constexpr int kFewestInstances = 6;
/// More would not make the median better.
constexpr int kMostInstances = 15;
/// The share of a sweep's time that solving alone may take, within those limits.
constexpr double kShareOfSweep = 0.005;

/// So many instances of a cell of median cost one thread solves, while the sweep solves its instances on all
/// threads at once. Of these the sweep's cell surely has times, however soon it ends.
int instance_count(const Experiment& experiment, std::size_t cells, int threads) {
  const double sweep = static_cast<double>(cells) * experiment.repetitions / threads;
  const auto affordable = static_cast<int>(std::min<double>(kMostInstances, kShareOfSweep * sweep));
  return std::min(next_look(experiment, 0), std::max(kFewestInstances, affordable));
}

Cell cell_of_median_cost(std::vector<Cell> cells, const Experiment& experiment) {
  cells = longest_first(std::move(cells), false, experiment.seed);
  return cells[cells.size() / 2];
}

Calibration::Entry entry_of(const std::string& method, const std::vector<double>& alone,
                            const std::vector<double>& together) {
  std::vector<double> ratios(alone.size());
  std::transform(together.begin(), together.end(), alone.begin(), ratios.begin(), std::divides<>());
  const auto interval = order_statistic_interval(ratios).value_or(
      OrderStatisticInterval{0, std::numeric_limits<double>::infinity()});
  return {method,         sample_median(alone), sample_median(together), sample_median(ratios),
          interval.lower, interval.upper};
}

}  // namespace

LoneSolves solve_alone(const SweepPlan& plan, const std::vector<Cell>& cells, int threads,
                       const std::vector<int>& cpus, const SweepHooks& hooks) {
  const Experiment& experiment = plan.experiment();
  LoneSolves alone = {cell_of_median_cost(cells, experiment), {}};
  run_team(1, cpus, [&](int, int) {
    CellRunner runner(plan, {}, hooks);
    std::optional<CellResult> result =
        runner.run_first(alone.cell, instance_count(experiment, cells.size(), threads));
    if (result) alone.records = std::move(result->records);
  });
  return alone;
}

Calibration calibration_of(const LoneSolves& alone, const std::vector<Record>& records) {
  Calibration calibration;
  if (alone.records.empty() || records.empty() || records.front().concurrency == 1) return calibration;
  calibration.threads = records.front().concurrency;
  const auto of_first = [&alone](const Record& record) {
    return record.repetition == alone.records.front().repetition;
  };
  const auto methods = static_cast<std::size_t>(
      std::find_if_not(alone.records.begin(), alone.records.end(), of_first) - alone.records.begin());
  for (std::size_t m = 0; m < methods; ++m) {
    std::vector<double> times_alone;
    std::vector<double> times_together;
    for (std::size_t i = m; i < std::min(alone.records.size(), records.size()); i += methods) {
      times_alone.push_back(alone.records[i].seconds);
      times_together.push_back(records[i].seconds);
    }
    calibration.entries.push_back(entry_of(alone.records[m].method, times_alone, times_together));
  }
  return calibration;
}

}  // namespace raygauge
