// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/sweep.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/sweep/calibration.h"
#include "engine/sweep/cell_runner.h"
#include "engine/sweep/schedule.h"
#include "engine/sweep/team.h"
#include "engine/sweep/thread_pin.h"
#include "engine/sweep/timed_solve.h"

namespace raygauge {
namespace {

/// The cells left to do, handed out one by one to whichever thread asks.
class CellQueue {
 public:
  CellQueue(std::vector<Cell> cells, const SweepHooks& hooks)
      : cells_(std::move(cells)), hooks_(hooks), start_(SteadyClock::now()) {
    for (const Cell& cell : cells_) total_cost_ += expected_cost(cell);
  }

  /// The next cell; null when there is none, or the sweep was asked to stop, or a thread failed.
  const Cell* take() {
    const std::lock_guard lock(mutex_);
    if (abandoned_ || next_ == cells_.size()) return nullptr;
    if (hooks_.stop_asked()) {
      abandoned_ = true;
      return nullptr;
    }
    return &cells_[next_++];
  }

  /// No more cells for anyone.
  void abandon() {
    const std::lock_guard lock(mutex_);
    abandoned_ = true;
  }

  void finish(const Cell& cell) {
    const std::lock_guard lock(mutex_);
    ++done_;
    done_cost_ += expected_cost(cell);
    if (hooks_.progress) hooks_.progress(progress());
  }

  std::size_t done() const { return done_; }
  bool complete() const { return done_ == cells_.size(); }

 private:
  SweepProgress progress() const {
    const double elapsed = seconds_since(start_);
    return {done_, cells_.size(), elapsed, elapsed * (total_cost_ - done_cost_) / done_cost_};
  }

  std::vector<Cell> cells_;
  const SweepHooks& hooks_;
  SteadyClock::time_point start_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::size_t done_ = 0;
  double done_cost_ = 0;
  double total_cost_ = 0;
  bool abandoned_ = false;
};

/// Passes cells on; of the one that was solved alone before the sweep it takes the calibration.
class CalibratingSink final : public RecordSink {
 public:
  CalibratingSink(RecordSink& sink, const LoneSolves& alone) : sink_(sink), alone_(alone) {}

  void store(const CellResult& cell) override {
    sink_.store(cell);
    if (cell.cell == alone_.cell.index) calibration_ = calibration_of(alone_, cell.records);
  }

  /// When the sweep has ended.
  const Calibration& calibration() const noexcept { return calibration_; }

 private:
  RecordSink& sink_;
  const LoneSolves& alone_;
  Calibration calibration_;
};

/// Puts the cell first: what was solved alone and what is solved among others are then close in time, on a
/// machine whose clock wanders.
void bring_forward(const Cell& cell, std::vector<Cell>& cells) {
  const auto place = std::find_if(cells.begin(), cells.end(),
                                  [&cell](const Cell& other) { return other.index == cell.index; });
  std::rotate(cells.begin(), place, place + 1);
}

std::vector<Cell> cells_to_do(const SweepPlan& plan, const std::set<std::uint64_t>& done) {
  std::vector<Cell> cells;
  for (const Cell& cell : plan.cells()) {
    if (done.count(cell.index) == 0) cells.push_back(cell);
  }
  return longest_first(std::move(cells), plan.experiment().shuffle, plan.experiment().seed);
}

void work_through(CellQueue& queue, const SweepPlan& plan, RecordSink& sink,
                  const CellRunner::Circumstances& circumstances, const SweepHooks& hooks) {
  try {
    CellRunner runner(plan, circumstances, hooks);
    while (const Cell* cell = queue.take()) {
      const std::optional<CellResult> result = runner.run(*cell);
      if (!result) return;  // asked to stop, as the other threads will find out
      sink.store(*result);
      queue.finish(*cell);
    }
  } catch (...) {
    queue.abandon();
    throw;
  }
}

}  // namespace

int sweep_threads(const Experiment& experiment, std::size_t cells) {
  if (experiment.timing == TimingMode::serial) return 1;
  const int asked = experiment.threads > 0 ? experiment.threads : omp_get_num_procs();
  return static_cast<int>(std::clamp<std::size_t>(cells, 1, static_cast<std::size_t>(asked)));
}

SweepSummary run_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                       const MethodRegistry& methods, RecordSink& sink, const std::set<std::uint64_t>& done,
                       const SweepHooks& hooks) {
  const SteadyClock::time_point start = SteadyClock::now();
  const SweepPlan plan(experiment, generators, methods);
  std::vector<Cell> cells = cells_to_do(plan, done);
  SweepSummary summary;
  if (cells.empty()) return summary;
  summary.threads = sweep_threads(experiment, cells.size());
  const std::vector<int> cpus = experiment.pin_threads ? allowed_cpus() : std::vector<int>();
  LoneSolves alone;
  if (summary.threads > 1) {
    alone = solve_alone(plan, cells, summary.threads, cpus, hooks);
    bring_forward(alone.cell, cells);
  }

  CalibratingSink calibrating(sink, alone);
  CellQueue queue(std::move(cells), hooks);
  std::atomic<int> granted{summary.threads};
  run_team(summary.threads, cpus, [&](int thread, int team_size) {
    granted = team_size;
    work_through(queue, plan, calibrating, {thread, team_size, start}, hooks);
  });
  summary.threads = granted;
  summary.calibration = calibrating.calibration();
  summary.cells_done = queue.done();
  summary.stopped = !queue.complete();
  summary.wall_seconds = seconds_since(start);
  return summary;
}

}  // namespace raygauge
