// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/estimate.h"

#include <gtest/gtest.h>

#include "raygauge/sweep/method.h"
#include "tests/engine/fake_components.h"

namespace raygauge::test_estimate {
namespace {

class Estimate : public ::testing::Test {
 protected:
  SweepEstimate estimate(const Experiment& experiment, double budget_seconds = 2) {
    return estimate_sweep(experiment, generators_, methods_, budget_seconds);
  }

  testing::CallLog log_;
  GeneratorRegistry generators_ = testing::fake_generators();
  MethodRegistry methods_ = testing::fake_methods(log_);
};

TEST_F(Estimate, CountsWhatTheSweepWillDo) {
  Experiment experiment = testing::small_experiment();
  experiment.threads = 3;
  const SweepEstimate result = estimate(experiment);
  EXPECT_EQ(result.cells, 12u);
  EXPECT_EQ(result.instances, 48u);
  EXPECT_EQ(result.records, 96u);
  EXPECT_EQ(result.threads, 3);
}

TEST_F(Estimate, ComesNearTheTimeOfSolvesThatAllTakeTheSame) {
  Experiment experiment = testing::small_experiment();
  experiment.threads = 1;
  experiment.warmup = 0;
  experiment.methods = {{"ray", "", {{"busy_seconds", 5e-3}}}};
  // 48 sleeps of 5 ms. A sleep is never shorter; how much longer it gets is the scheduler's to say on a busy
  // machine.
  const double seconds = estimate(experiment).seconds;
  EXPECT_GE(seconds, 0.99 * 48 * 5e-3);
  EXPECT_LE(seconds, 20 * 48 * 5e-3);
}

TEST_F(Estimate, ProbingStopsWhenTheBudgetIsSpent) {
  Experiment experiment = testing::small_experiment();
  experiment.methods = {{"ray", "", {{"busy_seconds", 0.02}}}};
  const SweepEstimate result = estimate(experiment, 0.01);
  EXPECT_EQ(result.probed_cells, 1u);
  EXPECT_EQ(log_.solves, 1);
  EXPECT_GT(result.seconds, 0);
}

TEST_F(Estimate, KeepsWithinItsBudgetOnAGridOfAMillionCells) {
  Experiment experiment = testing::small_experiment();
  experiment.n.clear();
  experiment.N.clear();
  for (int n = 1; n <= 80; ++n) experiment.n.push_back(n);
  for (int N = 1; N <= 12500; ++N) experiment.N.push_back(N);
  experiment.tolerance = {1e-6};
  experiment.generators[0].n = {};
  // From a microsecond to a quarter of an hour a solve.
  experiment.methods = {{"ray", "", {{"busy_seconds_of_cost", 1e-6}}}};
  const auto start = SteadyClock::now();
  const SweepEstimate result = estimate(experiment, 1);
  EXPECT_EQ(result.cells, 1000000u);
  EXPECT_LT(seconds_since(start), 3) << "a second, and what a busy machine adds";
  EXPECT_GT(result.seconds, 3600);
}

TEST_F(Estimate, ProbesSmallerCellsWhereAllAreLarge) {
  Experiment experiment = testing::small_experiment();
  experiment.n = {80};
  experiment.N = {100000};  // 6 hours a solve
  experiment.methods = {{"ray", "", {{"busy_seconds_of_cost", 1e-6}}}};
  const auto start = SteadyClock::now();
  const SweepEstimate result = estimate(experiment, 1);
  EXPECT_LT(seconds_since(start), 3);
  EXPECT_GT(result.probed_cells, 0u);
}

TEST_F(Estimate, TheLargestCellHoldsItsInstancesAndWhatTheMethodsMakeOfOne) {
  Experiment experiment = testing::small_experiment();
  const double points = estimate(experiment).largest_bytes;
  const Cell largest = estimate(experiment).largest;
  EXPECT_EQ(points, 8.0 * 2 * largest.n * largest.N * experiment.repetitions);
  for (const Cell& cell : grid_of(experiment)) EXPECT_LE(cell.n * cell.N, largest.n * largest.N);
  double heap = 0;
  const auto growing = [&heap] {
    return heap += 1000;
  };  // between two questions: what methods make of a probe
  const SweepEstimate with_models = estimate_sweep(experiment, generators_, methods_, 2, growing);
  EXPECT_GT(with_models.largest_bytes, points);
}

TEST_F(Estimate, RejectsWhatTheSweepWouldReject) {
  Experiment experiment = testing::small_experiment();
  experiment.methods[0].name = "rya";
  EXPECT_THROW(estimate(experiment), UnknownNameError);
}

}  // namespace
}  // namespace raygauge::test_estimate
