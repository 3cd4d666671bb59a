// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/cell_runner.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "engine/sweep/agreement.h"
#include "engine/sweep/limited_load.h"
#include "engine/sweep/repetitions.h"
#include "engine/sweep/seeded_order.h"

namespace raygauge {
namespace {

/// Coordinates that the instances of one batch may hold: 256 MB a thread.
constexpr double kBatchCoordinates = 256e6 / sizeof(double);

/// And at most so many instances: of bodies, which have few coordinates, each takes some kB.
constexpr int kBatchInstances = 4096;

/// The stream of a batch's order: of its own, or batches of one size would all put the same method first.
std::uint64_t order_stream(const Cell& cell, int first_repetition) {
  constexpr int kBitsOfCell = 32;  // a grid has far fewer cells
  return (static_cast<std::uint64_t>(first_repetition) << kBitsOfCell) + cell.index;
}

void copy_outcome(const DistanceResult& result, Record& record) {
  record.distance = result.distance;
  record.lower = result.lower;
  record.upper = result.upper;
  record.status = result.status;
  record.counters = result.counters;
}

}  // namespace

int batch_size(const Cell& cell, int repetitions) {
  const double coordinates = 2.0 * cell.n * cell.N;
  const int most = std::min(repetitions, kBatchInstances);
  return static_cast<int>(std::clamp(kBatchCoordinates / coordinates, 1.0, static_cast<double>(most)));
}

CellRunner::CellRunner(const SweepPlan& plan, const Circumstances& circumstances, SweepHooks hooks)
    : plan_(plan), circumstances_(circumstances), hooks_(std::move(hooks)), methods_(plan.make_methods()) {}

std::optional<CellResult> CellRunner::run(const Cell& cell) {
  const Experiment& experiment = plan_.experiment();
  CellResult result;
  result.cell = cell.index;
  int done = 0;
  do {
    const int look = next_look(experiment, done);
    if (!run_block(cell, done, look, result.records)) return std::nullopt;
    done = look;
  } while (done < experiment.repetitions &&
           !medians_known(result.records, methods_.size(), experiment.stop_when_within));
  return result;
}

std::optional<CellResult> CellRunner::run(const CellPiece& piece) {
  if (piece.first == 0 && piece.last == plan_.experiment().repetitions) return run(piece.cell);
  CellResult result{piece.cell.index, {}};
  if (!run_block(piece.cell, piece.first, piece.last, result.records)) return std::nullopt;
  return result;
}

std::optional<CellResult> CellRunner::run_first(const Cell& cell, int repetitions) {
  CellResult result{cell.index, {}};
  if (!run_block(cell, 0, repetitions, result.records)) return std::nullopt;
  return result;
}

Record CellRunner::blank_record(const Cell& cell, int repetition, std::size_t method) const {
  const Experiment& experiment = plan_.experiment();
  Record record;
  record.cell = cell.index;
  record.generator = experiment.generators[cell.generator].name;
  const SweepPlan::GeneratorFacts& facts = plan_.generator_facts(cell);
  record.generator_parameters = facts.parameters;
  record.exact_distance_rounding = facts.distance_rounding;
  record.hardness_label = facts.hardness_label;
  record.hardness = facts.hardness;
  record.method = label_of(experiment.methods[method]);
  record.method_parameters = plan_.method_parameters(method);
  record.method_name = experiment.methods[method].name;
  record.role = plan_.role(method);
  record.n = cell.n;
  record.N = cell.N;
  record.tolerance = cell.tolerance;
  record.seed = experiment.seed;
  record.repetition = repetition;
  record.thread = circumstances_.thread;
  record.concurrency = circumstances_.concurrency;
  return record;
}

void CellRunner::load(std::size_t method, const Instance& instance, const SolveRequest& request) {
  load_within(*methods_[method], label_of(plan_.experiment().methods[method]), instance, request.time_limit);
}

void CellRunner::warm_up(const Cell& cell, const Instance& instance) {
  if (plan_.experiment().warmup == 0) return;
  const SolveRequest request = plan_.request(cell);
  for (std::size_t m = 0; m < methods_.size(); ++m) {
    load(m, instance, request);
    for (int i = 0; i < plan_.experiment().warmup && !hooks_.stop_asked(); ++i) methods_[m]->solve(request);
  }
}

bool CellRunner::run_block(const Cell& cell, int first, int last, std::vector<Record>& records) {
  const int batch = batch_size(cell, last - first);
  while (first < last) {
    const int end = std::min(first + batch, last);
    if (!run_batch(cell, first, end, records)) return false;
    first = end;
  }
  return true;
}

bool CellRunner::run_batch(const Cell& cell, int first, int last, std::vector<Record>& records) {
  const std::size_t method_count = methods_.size();
  const std::size_t first_record = records.size();
  std::vector<Instance> instances;
  for (int repetition = first; repetition < last; ++repetition) {
    if (hooks_.stop_asked()) return false;
    instances.push_back(plan_.instance(cell, repetition));
    for (std::size_t m = 0; m < method_count; ++m) records.push_back(blank_record(cell, repetition, m));
  }
  if (first_record == 0) warm_up(cell, instances.front());
  for (const std::size_t slot :
       seeded_order(instances.size() * method_count, plan_.experiment().seed, order_stream(cell, first))) {
    if (hooks_.stop_asked()) return false;
    measure(cell, instances[slot / method_count], slot % method_count, records[first_record + slot]);
  }
  for (std::size_t i = first_record; i < records.size(); i += method_count) {
    mark_agreement(std::span(records).subspan(i, method_count));
  }
  return true;
}

void CellRunner::measure(const Cell& cell, const Instance& instance, std::size_t method, Record& record) {
  SolveMethod& solver = *methods_[method];
  record.started_at = seconds_since(circumstances_.sweep_start);
  const SteadyClock::time_point start = SteadyClock::now();
  const SolveRequest request = plan_.request(cell);
  load(method, instance, request);
  record.load_seconds = seconds_since(start);
  const TimedSolve timed = hooks_.time(solver, request, plan_.experiment().min_seconds);
  record.seconds = timed.seconds;
  record.inner_repetitions = timed.inner_repetitions;
  copy_outcome(solver.result(), record);
  record.exact_distance = instance.exact_distance.value_or(std::numeric_limits<double>::quiet_NaN());
  record.exact_distance_rounding = std::max(record.exact_distance_rounding, instance.exact_distance_rounding);
}

}  // namespace raygauge
