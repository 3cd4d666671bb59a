// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/estimate.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/sweep/cell_runner.h"
#include "engine/sweep/limited_load.h"
#include "engine/sweep/repetitions.h"
#include "engine/sweep/schedule.h"
#include "engine/sweep/sweep_plan.h"
#include "raygauge/sweep.h"
#include "raygauge/sweep/method.h"

namespace raygauge {
namespace {

/// The next probe costs so many times the last one: large steps reach dear cells in few solves, and small
/// ones make sure that none takes much longer than foreseen.
constexpr double kStep = 8;
/// A solve is foreseen to take no longer than this power of the cost makes of the last one. (Measured: the
/// simplex baselines come nearest to it.)
constexpr double kSteepest = 2;
/// Below this cost any method takes milliseconds.
constexpr double kCheap = 2000;

/// Seconds of one repetition with all methods, at a cell's expected cost.
struct Probe {
  double cost = 0;
  double seconds = 0;
  double model_bytes_a_coordinate = 0;  ///< of what the methods made of the instance
};

using HeapBytes = std::function<double()>;

double coordinates(const Cell& cell) { return 2.0 * cell.n * cell.N; }

Probe probe_of(const SweepPlan& plan, const Cell& cell, double budget_seconds, const HeapBytes& heap_bytes) {
  SolveRequest request = plan.request(cell);
  request.time_limit = std::min(request.time_limit, std::max(budget_seconds, 1e-3));
  const SteadyClock::time_point start = SteadyClock::now();
  const Instance instance = plan.instance(cell, 0);
  const std::vector<std::unique_ptr<SolveMethod>> methods = plan.make_methods();
  const double before = heap_bytes ? heap_bytes() : 0;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    load_within(*methods[m], label_of(plan.experiment().methods[m]), instance, request.time_limit);
    time_solve(*methods[m], request, plan.experiment().min_seconds);
  }
  const double made = heap_bytes ? std::max(0.0, heap_bytes() - before) : 0;
  return {expected_cost(cell), seconds_since(start), made / coordinates(cell)};
}

/// Smaller and smaller cells like `cell`, the smallest first, where `cell` itself may take long.
std::vector<Cell> smaller_cells(Cell cell) {
  constexpr int kFewDimensions = 4;
  std::vector<Cell> smaller;
  while (expected_cost(cell) > kCheap && cell.N > 1) {
    if (cell.n > kFewDimensions) cell.n /= 2;
    cell.N = std::max(1, cell.N / 2);
    smaller.push_back(cell);
  }
  std::reverse(smaller.begin(), smaller.end());
  return smaller;
}

/// What is to be probed, in increasing cost: cells of the grid in steps, after smaller ones if all are dear.
std::vector<Cell> candidates(const std::vector<Cell>& by_cost) {
  std::vector<Cell> result = smaller_cells(by_cost.front());
  result.push_back(by_cost.front());
  while (true) {
    const double last = expected_cost(result.back());
    const auto dearer = [](double cost, const Cell& cell) { return cost < expected_cost(cell); };
    const auto next = std::upper_bound(by_cost.begin(), by_cost.end(), last, dearer);
    if (next == by_cost.end()) return result;
    const auto beyond = std::upper_bound(next, by_cost.end(), kStep * last, dearer);
    result.push_back(beyond == next ? *next : *(beyond - 1));
  }
}

/// Probes cells of increasing cost while the next one is foreseen to end within the budget.
class Prober {
 public:
  Prober(const SweepPlan& plan, double budget_seconds, const HeapBytes& heap_bytes)
      : plan_(plan), budget_seconds_(budget_seconds), heap_bytes_(heap_bytes) {}

  std::vector<Probe> run(const std::vector<Cell>& by_cost) {
    const double smallest_of_grid = expected_cost(by_cost.front());
    for (const Cell& cell : candidates(by_cost)) {
      const double cost = expected_cost(cell);
      if (!probes_.empty() && seconds_left() < foreseen(cost)) break;
      try {
        const bool first = probes_.empty();
        probe(cell);
        if (!first || seconds_left() <= 0) continue;
        probes_.clear();  // first calls load libraries and touch memory
        probe(cell);
      } catch (const InvalidParameterError&) {
        if (cost >= smallest_of_grid) throw;  // else a size that the family does not have
      }
    }
    return probes_;
  }

 private:
  double seconds_left() const { return budget_seconds_ - seconds_since(start_); }
  double foreseen(double cost) const {
    return probes_.back().seconds * std::pow(cost / probes_.back().cost, kSteepest);
  }
  void probe(const Cell& cell) { probes_.push_back(probe_of(plan_, cell, seconds_left(), heap_bytes_)); }

  const SweepPlan& plan_;
  double budget_seconds_;
  const HeapBytes& heap_bytes_;
  SteadyClock::time_point start_ = SteadyClock::now();
  std::vector<Probe> probes_;
};

/// The power law through the two probes nearest to `cost`; proportional to cost if there is one only.
double seconds_at(double cost, const std::vector<Probe>& probes) {
  constexpr double kFlattest = 0.5;
  constexpr double kSteepestTrend = 3;
  if (probes.size() == 1) return probes.front().seconds * cost / probes.front().cost;
  std::size_t upper = 1;
  while (upper + 1 < probes.size() && probes[upper].cost < cost) ++upper;
  const Probe& a = probes[upper - 1];
  const Probe& b = probes[upper];
  const double slope = std::log(b.seconds / a.seconds) / std::log(b.cost / a.cost);
  const bool inside = a.cost <= cost && cost <= b.cost;
  const double exponent = inside ? slope : std::clamp(slope, kFlattest, kSteepestTrend);
  return b.seconds * std::pow(cost / b.cost, exponent);
}

}  // namespace

SweepEstimate estimate_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                             const MethodRegistry& methods, double budget_seconds,
                             const std::function<double()>& heap_bytes) {
  const SteadyClock::time_point start = SteadyClock::now();
  const SweepPlan plan(experiment, generators, methods);
  std::vector<Cell> by_cost = longest_first(plan.cells(), false, experiment.seed);
  std::reverse(by_cost.begin(), by_cost.end());
  const std::vector<Probe> probes =
      Prober(plan, budget_seconds - seconds_since(start), heap_bytes).run(by_cost);

  SweepEstimate estimate;
  estimate.cells = by_cost.size();
  estimate.instances = estimate.cells * static_cast<std::uint64_t>(experiment.repetitions);
  estimate.records = estimate.instances * experiment.methods.size();
  estimate.threads = sweep_threads(experiment, estimate.cells);
  const double longest = static_cast<double>(experiment.methods.size()) * experiment.time_limit;
  estimate.cell_seconds.resize(estimate.cells);
  for (const Cell& cell : by_cost) {
    double& seconds = estimate.cell_seconds[cell.index];
    seconds = (experiment.repetitions + experiment.warmup) *
              std::min(longest, seconds_at(expected_cost(cell), probes));
    estimate.seconds += seconds;
  }
  estimate.seconds /= estimate.threads;
  estimate.largest = *std::max_element(by_cost.begin(), by_cost.end(), [](const Cell& a, const Cell& b) {
    return coordinates(a) < coordinates(b);
  });
  const double instances = batch_size(estimate.largest, next_look(experiment, 0));
  estimate.largest_bytes =
      coordinates(estimate.largest) * (instances * sizeof(double) + probes.back().model_bytes_a_coordinate);
  estimate.probed_cells = probes.size();
  estimate.probing_seconds = seconds_since(start);
  return estimate;
}

}  // namespace raygauge
