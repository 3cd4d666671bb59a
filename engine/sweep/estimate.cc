// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/estimate.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/sweep/schedule.h"
#include "engine/sweep/sweep.h"
#include "engine/sweep/sweep_plan.h"
#include "engine/sweep/timed_solve.h"

namespace raygauge {
namespace {

constexpr std::size_t kProbes = 5;

/// Seconds of one repetition with all methods, at a cell's expected cost.
struct Probe {
  double cost = 0;
  double seconds = 0;
};

double repetition_seconds(const SweepPlan& plan, const Cell& cell, double budget_seconds) {
  SolveRequest request = plan.request(cell);
  request.time_limit = std::min(request.time_limit, budget_seconds);
  const SteadyClock::time_point start = SteadyClock::now();
  const Instance instance = plan.instance(cell, 0);
  for (const auto& method : plan.make_methods()) {
    method->load(instance);
    time_solve(*method, request, plan.experiment().min_seconds);
  }
  return seconds_since(start);
}

/// Probes cells of increasing cost, at most one of each cost, until the budget is spent.
std::vector<Probe> probe(const SweepPlan& plan, const std::vector<Cell>& by_cost, double budget_seconds) {
  const SteadyClock::time_point start = SteadyClock::now();
  repetition_seconds(plan, by_cost.front(), budget_seconds);  // first calls load libraries and touch memory
  std::vector<Probe> probes;
  for (std::size_t i = 0; i < kProbes && seconds_since(start) < budget_seconds; ++i) {
    const Cell& cell = by_cost[i * (by_cost.size() - 1) / (kProbes - 1)];
    if (!probes.empty() && expected_cost(cell) <= probes.back().cost) continue;
    probes.push_back({expected_cost(cell), repetition_seconds(plan, cell, budget_seconds)});
  }
  if (probes.empty()) {
    probes.push_back(
        {expected_cost(by_cost.front()), repetition_seconds(plan, by_cost.front(), budget_seconds)});
  }
  return probes;
}

/// The power law through the two probes nearest to `cost`; proportional to cost if there is one only.
double seconds_at(double cost, const std::vector<Probe>& probes) {
  if (probes.size() == 1) return probes.front().seconds * cost / probes.front().cost;
  std::size_t upper = 1;
  while (upper + 1 < probes.size() && probes[upper].cost < cost) ++upper;
  const Probe& a = probes[upper - 1];
  const Probe& b = probes[upper];
  const double exponent = std::log(b.seconds / a.seconds) / std::log(b.cost / a.cost);
  return a.seconds * std::pow(cost / a.cost, exponent);
}

}  // namespace

SweepEstimate estimate_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                             const MethodRegistry& methods, double budget_seconds) {
  const SteadyClock::time_point start = SteadyClock::now();
  const SweepPlan plan(experiment, generators, methods);
  std::vector<Cell> by_cost = longest_first(plan.cells(), false, experiment.seed);
  std::reverse(by_cost.begin(), by_cost.end());
  const std::vector<Probe> probes = probe(plan, by_cost, budget_seconds);

  SweepEstimate estimate;
  estimate.cells = by_cost.size();
  estimate.instances = estimate.cells * static_cast<std::uint64_t>(experiment.repetitions);
  estimate.records = estimate.instances * experiment.methods.size();
  estimate.threads = sweep_threads(experiment, estimate.cells);
  for (const Cell& cell : by_cost) {
    estimate.seconds +=
        (experiment.repetitions + experiment.warmup) * seconds_at(expected_cost(cell), probes);
  }
  estimate.seconds /= estimate.threads;
  estimate.probed_cells = probes.size();
  estimate.probing_seconds = seconds_since(start);
  return estimate;
}

}  // namespace raygauge
