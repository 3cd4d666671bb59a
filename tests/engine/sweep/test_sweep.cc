// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep.h"

#include <gtest/gtest.h>

#include <cmath>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "tests/engine/fake_sweep.h"

namespace raygauge::test_sweep {
namespace {

using testing::expect_same_outcome;
using testing::MemorySink;
using testing::small_experiment;

using Sweep = testing::FakeSweep;

TEST_F(Sweep, RunsEveryMethodOnEveryInstanceOfEveryCellOnce) {
  const Experiment experiment = small_experiment();
  MemorySink sink;
  const SweepSummary summary = run(experiment, sink);
  const std::vector<Cell> cells = grid_of(experiment);
  EXPECT_EQ(summary.cells_done, cells.size());
  EXPECT_FALSE(summary.stopped);
  ASSERT_EQ(sink.cells().size(), cells.size());
  for (const Cell& cell : cells) {
    EXPECT_EQ(sink.times_stored(cell.index), 1);
    const std::vector<Record>& records = sink.cells().at(cell.index).records;
    ASSERT_EQ(records.size(), 8u);
    for (std::size_t i = 0; i < records.size(); ++i) {
      EXPECT_EQ(records[i].cell, cell.index);
      EXPECT_EQ(records[i].repetition, static_cast<int>(i / 2));
      EXPECT_EQ(records[i].method, i % 2 == 0 ? "first" : "second");
      EXPECT_EQ(records[i].n, cell.n);
      EXPECT_EQ(records[i].N, cell.N);
      EXPECT_EQ(records[i].tolerance, cell.tolerance);
      EXPECT_EQ(records[i].generator, "ray");
      EXPECT_EQ(records[i].generator_parameters, "shift=0.5");
      EXPECT_EQ(records[i].method_parameters, "busy_seconds=0 busy_seconds_of_cost=0 error=0 throw_at=0");
      EXPECT_EQ(records[i].counters.pivots, cell.n);
      EXPECT_TRUE(records[i].agrees);
    }
  }
}

TEST_F(Sweep, RecordsDependNeitherOnThreadsNorOnOrder) {
  Experiment experiment = small_experiment();
  experiment.threads = 1;
  experiment.shuffle = false;
  MemorySink reference;
  run(experiment, reference);
  for (const int threads : {1, 2, 3}) {
    for (const bool shuffle : {false, true}) {
      for (const TimingMode timing : {TimingMode::serial, TimingMode::parallel}) {
        experiment.threads = threads;
        experiment.shuffle = shuffle;
        experiment.timing = timing;
        MemorySink sink;
        run(experiment, sink);
        expect_same_outcome(reference, sink);
      }
    }
  }
}

TEST_F(Sweep, AResumedSweepRunsTheMissingCellsAlone) {
  const Experiment experiment = small_experiment();
  MemorySink reference;
  run(experiment, reference);
  for (std::uint64_t kept = 0; kept <= reference.cells().size(); ++kept) {
    std::set<std::uint64_t> done;
    MemorySink sink;
    for (std::uint64_t index = 0; index < kept; ++index) {
      done.insert(index * 5 % 12);  // 5 and 12 are coprime: every cell once
      sink.store(reference.cells().at(index * 5 % 12));
    }
    const SweepSummary summary = run(experiment, sink, done);
    EXPECT_EQ(summary.cells_done, reference.cells().size() - kept);
    expect_same_outcome(reference, sink);
  }
}

TEST_F(Sweep, SerialTimingSolvesOnOneThread) {
  Experiment experiment = small_experiment();
  experiment.timing = TimingMode::serial;
  experiment.threads = 2;
  MemorySink sink;
  const SweepSummary summary = run(experiment, sink);
  EXPECT_EQ(summary.threads, 1);
  EXPECT_TRUE(summary.calibration.entries.empty());
  for (const auto& [index, cell] : sink.cells()) {
    for (const Record& record : cell.records) {
      EXPECT_EQ(record.thread, 0) << index;
      EXPECT_EQ(record.concurrency, 1);
    }
  }
}

/// Before a sweep one thread solves all instances of small_experiment's cell of median cost by both methods.
int samples_alone(const Experiment& experiment) {
  return experiment.repetitions * static_cast<int>(experiment.methods.size());
}

/// Keeps the first thread that comes waiting for a second one.
class MeetingOfTwo {
 public:
  /// False if there is no second thread within a minute.
  bool attend() {
    std::unique_lock lock(mutex_);
    present_.insert(std::this_thread::get_id());
    arrived_.notify_all();
    return arrived_.wait_for(lock, std::chrono::minutes(1), [this] { return present_.size() == 2; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::set<std::thread::id> present_;
};

TEST_F(Sweep, ParallelTimingUsesAllThreadsAndIsCalibrated) {
  Experiment experiment = small_experiment();
  experiment.threads = 2;
  std::atomic<int> samples{0};
  std::atomic<bool> met{true};
  MeetingOfTwo meeting;
  SweepHooks hooks;
  hooks.time = [&](SolveMethod& method, const SolveRequest& request, double) {
    if (++samples > samples_alone(experiment) && met) met = meeting.attend();
    method.solve(request);
    return TimedSolve{1e-3, 1};
  };
  MemorySink sink;
  const SweepSummary summary = run(experiment, sink, {}, hooks);
  EXPECT_TRUE(met);
  EXPECT_EQ(summary.threads, 2);
  ASSERT_EQ(summary.calibration.entries.size(), 2u);
  EXPECT_EQ(summary.calibration.entries[0].method, "first");
  EXPECT_EQ(summary.calibration.entries[0].slowdown, 1);
  std::set<int> threads;
  for (const auto& entry : sink.cells()) {
    for (const Record& record : entry.second.records) {
      EXPECT_EQ(record.concurrency, 2);
      threads.insert(record.thread);
    }
  }
  EXPECT_EQ(threads, (std::set<int>{0, 1}));
}

TEST_F(Sweep, TheSolvesOfItsFirstCellAreComparedWithThoseMadeAlone) {
  Experiment experiment = small_experiment();
  experiment.threads = 2;
  std::atomic<int> samples{0};
  SweepHooks hooks;
  hooks.time = [&](SolveMethod& method, const SolveRequest& request, double) {
    method.solve(request);
    return TimedSolve{++samples <= samples_alone(experiment) ? 0.5 : 1.0, 1};
  };
  MemorySink sink;
  const SweepSummary summary = run(experiment, sink, {}, hooks);
  EXPECT_EQ(summary.calibration.threads, 2);
  ASSERT_EQ(summary.calibration.entries.size(), 2u);
  for (const Calibration::Entry& entry : summary.calibration.entries) {
    EXPECT_EQ(entry.serial_seconds, 0.5);
    EXPECT_EQ(entry.parallel_seconds, 1);
    EXPECT_EQ(entry.slowdown, 2);
  }
}

TEST_F(Sweep, WarmUpSolvesComeOnTopOfTheTimedOnes) {
  Experiment experiment = small_experiment();
  experiment.timing = TimingMode::serial;
  experiment.warmup = 3;
  MemorySink sink;
  run(experiment, sink);
  // min_seconds = 0: a sample is one solve. 12 cells of 2 methods, each 3 warm-up solves and 4 samples.
  EXPECT_EQ(log_.solves, 12 * 2 * (3 + 4));
  EXPECT_EQ(log_.loads, 12 * 2 * (1 + 4));
}

TEST_F(Sweep, TimesAreThoseOfOneSolve) {
  Experiment experiment = small_experiment();
  experiment.timing = TimingMode::serial;
  experiment.n = {3};
  experiment.N = {10};
  experiment.min_seconds = 3e-3;
  experiment.methods = {{"ray", "short", {{"busy_seconds", 1e-4}}},
                        {"ray", "long", {{"busy_seconds", 4e-3}}}};
  MemorySink sink;
  run(experiment, sink);
  int repeated_short_samples = 0;
  for (const auto& entry : sink.cells()) {
    for (const Record& record : entry.second.records) {
      const bool is_short = record.method == "short";
      EXPECT_GE(record.seconds, is_short ? 1e-4 : 4e-3);
      EXPECT_GE(record.seconds * record.inner_repetitions, 3e-3 * (1 - 1e-12));
      if (is_short && record.inner_repetitions > 1) ++repeated_short_samples;
      if (!is_short) {
        EXPECT_EQ(record.inner_repetitions, 1);
      }
    }
  }
  // On a busy machine a single short sleep may last long enough, but not all eight.
  EXPECT_GT(repeated_short_samples, 0);
}

TEST_F(Sweep, AWrongMethodIsStoredAsADisagreement) {
  Experiment experiment = small_experiment();
  experiment.methods.push_back({"ray", "wrong", {{"error", 0.01}}});
  MemorySink sink;
  run(experiment, sink);
  for (const auto& entry : sink.cells()) {
    EXPECT_EQ(entry.second.records.size(), 12u);
    for (const Record& record : entry.second.records) EXPECT_FALSE(record.agrees);
  }
}

TEST_F(Sweep, AnExceptionOfAMethodEndsTheSweepAndIsRethrown) {
  for (const int threads : {1, 2}) {
    Experiment experiment = small_experiment();
    experiment.threads = threads;
    experiment.methods[0].parameters["throw_at"] = std::int64_t{60};
    log_.solves = 0;
    MemorySink sink;
    EXPECT_THROW(run(experiment, sink), Error);
    EXPECT_LT(sink.cells().size(), 12u);
    for (const auto& entry : sink.cells()) EXPECT_EQ(entry.second.records.size(), 8u);
  }
}

TEST_F(Sweep, AnExceptionOfTheSinkEndsTheSweepAndIsRethrown) {
  class FullSink final : public RecordSink {
   public:
    void store(const CellResult&) override {
      ++calls;
      throw Error("no space left on device");
    }
    std::atomic<int> calls{0};
  };
  Experiment experiment = small_experiment();
  experiment.threads = 2;
  FullSink sink;
  EXPECT_THROW(run(experiment, sink), Error);
  EXPECT_LE(sink.calls, 2);
}

TEST_F(Sweep, ACellThatTheGeneratorRefusesIsNamed) {
  Experiment experiment = small_experiment();
  experiment.n = {3, 91};
  experiment.N = {10};
  experiment.tolerance = {1e-6};
  MemorySink sink;
  try {
    run(experiment, sink);
    FAIL() << "accepted n = 91";
  } catch (const InvalidParameterError& error) {
    EXPECT_STREQ(error.what(), "cell 1 (generator 'ray', n = 91, N = 10): the family 'ray' ends at n = 90");
  }
}

TEST_F(Sweep, UnknownNamesAndParametersAreRejectedBeforeAnythingRuns) {
  MemorySink sink;
  Experiment no_method = small_experiment();
  no_method.methods[1].name = "rya";
  EXPECT_THROW(run(no_method, sink), UnknownNameError);
  Experiment no_generator = small_experiment();
  no_generator.generators[0].name = "rya";
  EXPECT_THROW(run(no_generator, sink), UnknownNameError);
  Experiment no_parameter = small_experiment();
  no_parameter.methods[0].parameters["eror"] = 0.5;
  EXPECT_THROW(run(no_parameter, sink), UnknownNameError);
  EXPECT_EQ(log_.solves, 0);
  EXPECT_TRUE(sink.cells().empty());
}

TEST_F(Sweep, ProgressCountsUpToTheEnd) {
  std::vector<SweepProgress> told;
  SweepHooks hooks;
  hooks.progress = [&](const SweepProgress& progress) { told.push_back(progress); };
  MemorySink sink;
  run(small_experiment(), sink, {3, 4}, hooks);
  ASSERT_EQ(told.size(), 10u);
  for (std::size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].cells_done, i + 1);
    EXPECT_EQ(told[i].cells_total, 10u);
  }
  EXPECT_EQ(told.back().remaining_seconds, 0);
  EXPECT_GT(told.front().remaining_seconds, 0);
}

TEST_F(Sweep, NothingLeftToDoIsNoError) {
  MemorySink sink;
  Experiment experiment = small_experiment();
  experiment.n = {3};
  experiment.N = {10};
  experiment.tolerance = {1e-6};
  const SweepSummary summary = run(experiment, sink, {0});
  EXPECT_EQ(summary.cells_done, 0u);
  EXPECT_FALSE(summary.stopped);
  EXPECT_EQ(log_.solves, 0);
}

}  // namespace
}  // namespace raygauge::test_sweep
