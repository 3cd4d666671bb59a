// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/calibration.h"

#include <algorithm>
#include <cstddef>

#include "engine/sweep/order_statistics.h"
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
  CalibrationThread(const SweepPlan& plan, const Cell& cell, int instances, const SweepHooks& hooks)
      : plan_(plan), hooks_(hooks), request_(plan.request(cell)), methods_(plan.make_methods()) {
    for (int i = 0; i < instances; ++i) instances_.push_back(plan.instance(cell, i));
    for (const auto& method : methods_) {
      if (hooks_.stop_asked()) return;
      method->load(instances_.front());
      method->solve(request_);
    }
    times_.reserve(methods_.size() * instances_.size());
  }

  /// Ends early when the sweep is asked to stop.
  void measure() {
    for (const auto& method : methods_) {
      for (const Instance& instance : instances_) {
        if (hooks_.stop_asked()) return;
        method->load(instance);
        times_.push_back(hooks_.time(*method, request_, plan_.experiment().min_seconds).seconds);
      }
    }
  }

  SolveTimes take_times() { return std::move(times_); }

 private:
  const SweepPlan& plan_;
  const SweepHooks& hooks_;
  SolveRequest request_;
  std::vector<std::unique_ptr<SolveMethod>> methods_;
  std::vector<Instance> instances_;
  SolveTimes times_;
};

std::vector<SolveTimes> times_of_team(const SweepPlan& plan, const Cell& cell, int instances, int threads,
                                      const std::vector<int>& cpus, const SweepHooks& hooks) {
  std::vector<SolveTimes> times(static_cast<std::size_t>(threads));
  FirstError preparation;
  run_team(threads, cpus, [&](int thread, int) {
    std::unique_ptr<CalibrationThread> own;
    preparation.guard([&] { own = std::make_unique<CalibrationThread>(plan, cell, instances, hooks); });
#pragma omp barrier
    if (preparation.occurred()) return;
    own->measure();
    times[static_cast<std::size_t>(thread)] = own->take_times();
  });
  preparation.rethrow();
  return times;
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

/// The times of method `index` out of those of all methods; empty if there are none.
std::span<const double> times_of_method(const SolveTimes& times, std::size_t index, std::size_t instances) {
  return times.empty() ? std::span<const double>() : std::span(times).subspan(index * instances, instances);
}

}  // namespace

Calibration::Entry calibration_entry(const std::string& method, std::span<const double> serial,
                                     const std::vector<std::span<const double>>& parallel) {
  std::vector<double> together;
  std::vector<double> ratios;
  for (const std::span<const double> thread : parallel) {
    for (std::size_t r = 0; r < thread.size(); ++r) {
      together.push_back(thread[r]);
      ratios.push_back(thread[r] / serial[r]);
    }
  }
  return {method, sample_median({serial.begin(), serial.end()}), sample_median(together),
          sample_median(ratios)};
}

Calibration calibrate(const SweepPlan& plan, const std::vector<Cell>& cells, int threads,
                      const std::vector<int>& cpus, const SweepHooks& hooks) {
  const Experiment& experiment = plan.experiment();
  const Cell cell = cell_of_median_cost(cells, experiment);
  const int instances = instance_count(experiment, cells.size(), threads);
  const SolveTimes serial = times_of_team(plan, cell, instances, 1, cpus, hooks).front();
  const std::vector<SolveTimes> parallel = times_of_team(plan, cell, instances, threads, cpus, hooks);
  if (hooks.stop_asked()) return {};
  Calibration calibration;
  calibration.threads = threads;
  const auto count = static_cast<std::size_t>(instances);
  for (std::size_t m = 0; m < experiment.methods.size(); ++m) {
    std::vector<std::span<const double>> together;
    for (const SolveTimes& thread : parallel) together.push_back(times_of_method(thread, m, count));
    calibration.entries.push_back(
        calibration_entry(label_of(experiment.methods[m]), times_of_method(serial, m, count), together));
  }
  return calibration;
}

}  // namespace raygauge
