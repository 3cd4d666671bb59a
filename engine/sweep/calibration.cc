// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/calibration.h"

#include <algorithm>
#include <cstddef>

#include "engine/sweep/schedule.h"
#include "engine/sweep/team.h"
#include "engine/sweep/timed_solve.h"

namespace raygauge {
namespace {

/// Enough for a median, even if the sweep is short.
constexpr int kFewestInstances = 3;
/// More would not make the median better.
constexpr int kMostInstances = 15;
/// The share of a sweep's time that calibration may take, within those limits.
constexpr double kShareOfSweep = 0.01;

/// Seconds of every calibration solve on one thread, at [method * instances + instance].
using SolveTimes = std::vector<double>;

/// Times one thread's solves. All threads of the team start the timed part together.
class CalibrationThread {
 public:
  CalibrationThread(const SweepPlan& plan, const Cell& cell, int instances)
      : plan_(plan), request_(plan.request(cell)), methods_(plan.make_methods()) {
    for (int i = 0; i < instances; ++i) instances_.push_back(plan.instance(cell, i));
    for (const auto& method : methods_) {
      method->load(instances_.front());
      method->solve(request_);
    }
    times_.reserve(methods_.size() * instances_.size());
  }

  void measure() {
    for (const auto& method : methods_) {
      for (const Instance& instance : instances_) {
        method->load(instance);
        times_.push_back(time_solve(*method, request_, plan_.experiment().min_seconds).seconds);
      }
    }
  }

  SolveTimes take_times() { return std::move(times_); }

 private:
  const SweepPlan& plan_;
  SolveRequest request_;
  std::vector<std::unique_ptr<SolveMethod>> methods_;
  std::vector<Instance> instances_;
  SolveTimes times_;
};

std::vector<SolveTimes> times_of_team(const SweepPlan& plan, const Cell& cell, int instances, int threads,
                                      const std::vector<int>& cpus) {
  std::vector<SolveTimes> times(static_cast<std::size_t>(threads));
  FirstError preparation;
  run_team(threads, cpus, [&](int thread, int) {
    std::unique_ptr<CalibrationThread> own;
    preparation.guard([&] { own = std::make_unique<CalibrationThread>(plan, cell, instances); });
#pragma omp barrier
    if (preparation.occurred()) return;
    own->measure();
    times[static_cast<std::size_t>(thread)] = own->take_times();
  });
  preparation.rethrow();
  return times;
}

double median(std::vector<double> values) {
  const std::size_t half = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half), values.end());
  if (values.size() % 2 == 1) return values[half];
  const double upper = values[half];
  return (*std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half)) + upper) / 2;
}

/// Both phases solve so many instances of a cell of median cost, while the sweep solves its instances on all
/// threads at once.
int instance_count(const Experiment& experiment, std::size_t cells, int threads) {
  const double sweep = static_cast<double>(cells) * experiment.repetitions / threads;
  const auto affordable = static_cast<int>(std::min<double>(kMostInstances, kShareOfSweep * sweep / 2));
  return std::min(experiment.repetitions, std::max(kFewestInstances, affordable));
}

Cell cell_of_median_cost(std::vector<Cell> cells, const Experiment& experiment) {
  cells = longest_first(std::move(cells), false, experiment.seed);
  return cells[cells.size() / 2];
}

Calibration::Entry entry_of(const std::string& label, const SolveTimes& serial,
                            const std::vector<SolveTimes>& parallel, std::size_t first, std::size_t count) {
  std::vector<double> alone;
  std::vector<double> together;
  std::vector<double> ratios;
  for (std::size_t i = first; i < first + count; ++i) {
    alone.push_back(serial[i]);
    for (const SolveTimes& thread : parallel) {
      if (thread.empty()) continue;  // the runtime granted fewer threads
      together.push_back(thread[i]);
      ratios.push_back(thread[i] / serial[i]);
    }
  }
  return {label, median(alone), median(together), median(ratios)};
}

}  // namespace

Calibration calibrate(const SweepPlan& plan, const std::vector<Cell>& cells, int threads,
                      const std::vector<int>& cpus) {
  const Experiment& experiment = plan.experiment();
  const Cell cell = cell_of_median_cost(cells, experiment);
  const int instances = instance_count(experiment, cells.size(), threads);
  const SolveTimes serial = times_of_team(plan, cell, instances, 1, cpus).front();
  const std::vector<SolveTimes> parallel = times_of_team(plan, cell, instances, threads, cpus);
  Calibration calibration;
  calibration.threads = threads;
  const auto count = static_cast<std::size_t>(instances);
  for (std::size_t m = 0; m < experiment.methods.size(); ++m) {
    calibration.entries.push_back(
        entry_of(label_of(experiment.methods[m]), serial, parallel, m * count, count));
  }
  return calibration;
}

}  // namespace raygauge
