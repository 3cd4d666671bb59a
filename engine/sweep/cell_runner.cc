// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/cell_runner.h"

#include <algorithm>
#include <limits>
#include <span>

#include "engine/sweep/agreement.h"
#include "engine/sweep/seeded_order.h"

namespace raygauge {
namespace {

/// Coordinates that the instances of one batch may hold: 256 MB a thread.
constexpr double kBatchCoordinates = 256e6 / sizeof(double);

int batch_size(const Cell& cell, int repetitions) {
  const double coordinates = 2.0 * cell.n * cell.N;
  return static_cast<int>(std::clamp(kBatchCoordinates / coordinates, 1.0, static_cast<double>(repetitions)));
}

void copy_outcome(const DistanceResult& result, Record& record) {
  record.distance = result.distance;
  record.lower = result.lower;
  record.upper = result.upper;
  record.status = result.status;
  record.counters = result.counters;
}

}  // namespace

CellRunner::CellRunner(const SweepPlan& plan, const Circumstances& circumstances)
    : plan_(plan), circumstances_(circumstances), methods_(plan.make_methods()) {}

CellResult CellRunner::run(const Cell& cell) {
  const int repetitions = plan_.experiment().repetitions;
  const std::size_t method_count = methods_.size();
  CellResult result;
  result.cell = cell.index;
  result.records.reserve(static_cast<std::size_t>(repetitions) * method_count);
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t m = 0; m < method_count; ++m) {
      result.records.push_back(blank_record(cell, repetition, m));
    }
  }
  const int batch = batch_size(cell, repetitions);
  for (int first = 0; first < repetitions; first += batch) {
    run_batch(cell, first, std::min(first + batch, repetitions), result.records);
  }
  for (std::size_t first = 0; first < result.records.size(); first += method_count) {
    mark_agreement(std::span(result.records).subspan(first, method_count));
  }
  return result;
}

Record CellRunner::blank_record(const Cell& cell, int repetition, std::size_t method) const {
  const Experiment& experiment = plan_.experiment();
  Record record;
  record.cell = cell.index;
  record.generator = experiment.generators[cell.generator].name;
  record.generator_parameters = plan_.generator_parameters(cell);
  record.method = label_of(experiment.methods[method]);
  record.method_parameters = plan_.method_parameters(method);
  record.n = cell.n;
  record.N = cell.N;
  record.tolerance = cell.tolerance;
  record.seed = experiment.seed;
  record.repetition = repetition;
  record.thread = circumstances_.thread;
  record.concurrency = circumstances_.concurrency;
  return record;
}

void CellRunner::warm_up(const Cell& cell, const Instance& instance) {
  if (plan_.experiment().warmup == 0) return;
  for (const auto& method : methods_) {
    method->load(instance);
    for (int i = 0; i < plan_.experiment().warmup; ++i) method->solve(plan_.request(cell));
  }
}

void CellRunner::run_batch(const Cell& cell, int first_repetition, int last_repetition,
                           std::vector<Record>& records) {
  std::vector<Instance> instances;
  for (int repetition = first_repetition; repetition < last_repetition; ++repetition) {
    instances.push_back(plan_.instance(cell, repetition));
  }
  if (first_repetition == 0) warm_up(cell, instances.front());
  const std::size_t method_count = methods_.size();
  const std::size_t first_record = static_cast<std::size_t>(first_repetition) * method_count;
  for (const std::size_t slot :
       seeded_order(instances.size() * method_count, plan_.experiment().seed, cell.index)) {
    measure(cell, instances[slot / method_count], slot % method_count, records[first_record + slot]);
  }
}

void CellRunner::measure(const Cell& cell, const Instance& instance, std::size_t method, Record& record) {
  SolveMethod& solver = *methods_[method];
  record.started_at = seconds_since(circumstances_.sweep_start);
  const SteadyClock::time_point start = SteadyClock::now();
  solver.load(instance);
  record.load_seconds = seconds_since(start);
  const TimedSolve timed = time_solve(solver, plan_.request(cell), plan_.experiment().min_seconds);
  record.seconds = timed.seconds;
  record.inner_repetitions = timed.inner_repetitions;
  copy_outcome(solver.result(), record);
  record.exact_distance = instance.exact_distance.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace raygauge
