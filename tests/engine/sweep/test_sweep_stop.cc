// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A sweep that is asked to stop, between any two solves.
#include <gtest/gtest.h>

#include <atomic>

#include "tests/engine/fake_sweep.h"

namespace raygauge::test_sweep_stop {
namespace {

using testing::expect_same_outcome;
using testing::MemorySink;
using testing::small_experiment;

class SweepStop : public testing::FakeSweep {
 protected:
  /// Hooks that ask to stop once `most` samples have been taken.
  SweepHooks stop_after(int most) {
    samples_ = 0;
    SweepHooks hooks;
    hooks.stop = [this, most] { return samples_ >= most; };
    hooks.time = [this](SolveMethod& method, const SolveRequest& request, double) {
      ++samples_;
      method.solve(request);
      return TimedSolve{1e-6, 1};
    };
    return hooks;
  }

  std::atomic<int> samples_{0};
};

TEST_F(SweepStop, TakesNoFurtherSampleAndDropsTheCellInFlight) {
  Experiment experiment = small_experiment();  // a cell is 8 samples
  experiment.threads = 1;
  MemorySink sink;
  const SweepSummary summary = run(experiment, sink, {}, stop_after(3 * 8 + 5));
  EXPECT_TRUE(summary.stopped);
  EXPECT_EQ(summary.cells_done, 3u);
  EXPECT_EQ(sink.cells().size(), 3u);
  EXPECT_EQ(samples_, 3 * 8 + 5);
  for (const auto& entry : sink.cells()) EXPECT_EQ(entry.second.records.size(), 8u);
}

TEST_F(SweepStop, AfterTheLastSampleOfACellTheCellIsKept) {
  Experiment experiment = small_experiment();
  experiment.threads = 1;
  MemorySink sink;
  EXPECT_EQ(run(experiment, sink, {}, stop_after(3 * 8)).cells_done, 3u);
  EXPECT_EQ(sink.cells().size(), 3u);
}

TEST_F(SweepStop, AndResumedHasEveryRecordOnceWhereverItWasStopped) {
  Experiment experiment = small_experiment();
  MemorySink reference;
  run(experiment, reference);
  for (const int threads : {1, 2}) {
    experiment.threads = threads;
    for (int most = 0; most < 12 * 8 + 40; most += 7) {
      MemorySink sink;
      run(experiment, sink, {}, stop_after(most));
      std::set<std::uint64_t> done;
      for (const auto& entry : sink.cells()) done.insert(entry.first);
      EXPECT_FALSE(run(experiment, sink, done).stopped);
      expect_same_outcome(reference, sink);
    }
  }
}

TEST_F(SweepStop, DuringCalibrationLeavesNeitherCellsNorACalibration) {
  Experiment experiment = small_experiment();
  experiment.threads = 2;
  MemorySink sink;
  const SweepSummary summary = run(experiment, sink, {}, stop_after(1));
  EXPECT_TRUE(summary.stopped);
  EXPECT_EQ(summary.cells_done, 0u);
  EXPECT_TRUE(summary.calibration.entries.empty());
  EXPECT_EQ(samples_, 1);
}

TEST_F(SweepStop, NorDoesItWarmUp) {
  Experiment experiment = small_experiment();
  experiment.threads = 1;
  experiment.warmup = 1000000;
  SweepHooks hooks;
  hooks.stop = [this] { return log_.solves >= 10; };
  MemorySink sink;
  EXPECT_TRUE(run(experiment, sink, {}, hooks).stopped);
  EXPECT_EQ(log_.solves, 10);
}

}  // namespace
}  // namespace raygauge::test_sweep_stop
