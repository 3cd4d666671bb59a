// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <memory>
#include <vector>

#include "bench/bin.h"
#include "bench/tuning_workloads.h"
#include "scene/simulation/simulation_part.h"

namespace raygauge::bench {
namespace {

// Where the own methods do not end, the best that they have found stays.
class NoOtherSolver final : public FrictionSolver {
 public:
  void solve(const FrictionProblem& /*problem*/, Eigen::VectorXd& /*r*/) override {}
};

// What is stored when the share of the time is over.
SimulationPart part_until(const Bin& bin, double share) {
  NoOtherSolver other;
  SimulationPart part;
  double done = 0;
  SimulationHooks hooks;
  hooks.progress = [&done](double now) { done = now; };
  hooks.stop = [&done, share] { return done >= share; };
  hooks.store = [&part](const SimulationPart& found) { part = found; };
  simulate(bin.scene(), bin.dynamics(), &other, hooks);
  return part;
}

}  // namespace

Workload heap_steps(int bodies, double from, double to, int threads) {
  const auto bin = std::make_shared<const Bin>(bodies, to);
  const auto before = std::make_shared<std::vector<SimulationPart>>();
  return [=]() -> Call {
    if (before->empty()) before->push_back(part_until(*bin, from / to));
    return [=] {
      NoOtherSolver other;
      SimulationHooks hooks;
      hooks.threads = threads;
      simulate(bin->scene(), bin->dynamics(), &other, hooks, *before);
    };
  };
}

}  // namespace raygauge::bench
