// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>
#include <set>
#include <vector>

#include "engine/sweep/calibration.h"
#include "engine/sweep/cell_runner.h"
#include "engine/sweep/schedule.h"
#include "engine/sweep/share.h"
#include "engine/threads/team.h"
#include "engine/threads/thread_pin.h"
#include "raygauge/sweep/method.h"

namespace raygauge {
namespace {

/// The counter of a sweep that no other process works on.
class OwnCounter final : public PieceCounter {
 public:
  std::uint64_t next() override { return abandoned_ ? kBeyond : next_++; }
  std::uint64_t finish() override { return ++finished_; }
  void abandon() override { abandoned_ = true; }

 private:
  static constexpr std::uint64_t kBeyond = ~std::uint64_t{0};
  std::atomic<std::uint64_t> next_{0};
  std::atomic<std::uint64_t> finished_{0};
  std::atomic<bool> abandoned_{false};
};

/// The pieces left to do, handed out one by one to whichever thread asks.
class PieceQueue {
 public:
  PieceQueue(std::vector<CellPiece> pieces, PieceCounter& counter, const SweepHooks& hooks)
      : pieces_(std::move(pieces)), counter_(counter), hooks_(hooks), start_(SteadyClock::now()) {
    std::set<std::uint64_t> cells;
    for (const CellPiece& piece : pieces_) {
      cost_before_.push_back(total_cost_);
      total_cost_ += expected_cost(piece.cell) * (piece.last - piece.first);
      cells.insert(piece.cell.index);
    }
    cost_before_.push_back(total_cost_);
    cells_ = cells.size();
  }

  /// The next piece; null when there is none, or the sweep was asked to stop, or a thread failed.
  const CellPiece* take() {
    if (hooks_.stop_asked()) counter_.abandon();
    const std::uint64_t number = counter_.next();
    return number < pieces_.size() ? &pieces_[number] : nullptr;
  }

  void abandon() { counter_.abandon(); }

  void finish() {
    const std::lock_guard lock(mutex_);
    done_ = std::max(done_, counter_.finish());
    if (hooks_.progress) hooks_.progress(progress());
  }

  /// Cells as far as this process knows: pieces where some are split, as a share of all cells.
  std::uint64_t cells_done() const { return done_ * cells_ / std::max<std::size_t>(pieces_.size(), 1); }
  bool complete() const { return done_ == pieces_.size(); }

 private:
  SweepProgress progress() const {
    const double elapsed = seconds_since(start_);
    const double done_cost = cost_before_[done_];
    return {cells_done(), cells_, elapsed, elapsed * (total_cost_ - done_cost) / done_cost};
  }

  std::vector<CellPiece> pieces_;
  PieceCounter& counter_;
  const SweepHooks& hooks_;
  SteadyClock::time_point start_;
  std::vector<double> cost_before_;  ///< expected cost of the pieces before each, and of all
  double total_cost_ = 0;
  std::uint64_t cells_ = 0;

  std::mutex mutex_;        ///< guards what follows
  std::uint64_t done_ = 0;  ///< of all workers
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

/// Puts the cell's first piece first: what was solved alone and what is solved among others are then close in
/// time, on a machine whose clock wanders.
void bring_forward(const Cell& cell, std::vector<CellPiece>& pieces) {
  const auto place = std::find_if(pieces.begin(), pieces.end(),
                                  [&cell](const CellPiece& piece) { return piece.cell.index == cell.index; });
  std::rotate(pieces.begin(), place, place + 1);
}

/// The cells whose first repetition is still to be done, so that times alone find their counterparts.
std::vector<Cell> cells_of(const std::vector<CellPiece>& pieces, int repetitions) {
  std::vector<Cell> cells;
  for (const CellPiece& piece : pieces) {
    if (piece.first == 0 && piece.last == repetitions) cells.push_back(piece.cell);
  }
  return cells;
}

void work_through(PieceQueue& queue, CellRunner& runner, RecordSink& sink) {
  while (const CellPiece* piece = queue.take()) {
    const std::optional<CellResult> result = runner.run(*piece);
    if (!result) return;  // asked to stop, as the other threads will find out
    sink.store(*result);
    queue.finish();
  }
}

/// The same instances as were solved alone, once more while the others solve too; these times are not stored.
Calibration calibrate_among_others(const LoneSolves& alone, CellRunner& runner, std::size_t methods) {
  if (alone.records.empty()) return {};
  const auto instances = static_cast<int>(alone.records.size() / methods);
  const std::optional<CellResult> together = runner.run_first(alone.cell, instances);
  return together ? calibration_of(alone, together->records) : Calibration();
}

}  // namespace

int sweep_threads(const Experiment& experiment, std::size_t cells) {
  if (experiment.timing == TimingMode::serial) return 1;
  const int asked = experiment.threads > 0 ? experiment.threads : omp_get_num_procs();
  return static_cast<int>(std::clamp<std::size_t>(cells, 1, static_cast<std::size_t>(asked)));
}

std::vector<CellPiece> pieces_to_do(const Experiment& experiment, const std::vector<Cell>& grid,
                                    const DoneCells& done, const SweepShare& share) {
  if (share.shard.count > 1) return pieces_of_shard(experiment, grid, done, share.shard);
  std::vector<Cell> cells;
  for (const Cell& cell : grid) {
    if (done.whole().count(cell.index) == 0) cells.push_back(cell);
  }
  const std::vector<Cell> ordered = longest_first(std::move(cells), experiment.shuffle, experiment.seed);
  return pieces_of(experiment, ordered, done, share.processes > 1 ? share.workers : 1);
}

SweepSummary run_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                       const MethodRegistry& methods, RecordSink& sink, const DoneCells& done,
                       const SweepHooks& hooks, const SweepShare& share) {
  const SteadyClock::time_point start = SteadyClock::now();
  const SweepPlan plan(experiment, generators, methods);
  std::vector<CellPiece> pieces = pieces_to_do(experiment, plan.cells(), done, share);
  SweepSummary summary;
  if (pieces.empty()) return summary;
  const bool shared = share.processes > 1;
  summary.threads = shared ? share.threads : sweep_threads(experiment, pieces.size());
  const std::vector<int> cpus = share.cpus          ? *share.cpus
                                : experiment.pins() ? allowed_cpus_from_here()
                                                    : std::vector<int>();
  const std::vector<Cell> whole = cells_of(pieces, experiment.repetitions);
  const bool calibrates = !whole.empty() && (shared ? share.calibrates : summary.threads > 1);
  LoneSolves alone;
  if (calibrates) alone = solve_alone(plan, whole, std::max(summary.threads, share.concurrency), cpus, hooks);
  if (calibrates && !shared) bring_forward(alone.cell, pieces);
  if (shared) share.wait_for_the_rest();

  CalibratingSink calibrating(sink, alone);
  OwnCounter own;
  PieceQueue queue(std::move(pieces), shared ? *share.counter : own, hooks);
  std::atomic<int> granted{summary.threads};
  run_team(summary.threads, cpus, [&](int thread, int team_size) {
    granted = team_size;
    try {
      CellRunner runner(plan, {thread, shared ? share.concurrency : team_size, start}, hooks);
      if (shared && calibrates && thread == 0) {
        summary.calibration = calibrate_among_others(alone, runner, experiment.methods.size());
      }
      work_through(queue, runner, shared ? sink : calibrating);
    } catch (...) {
      queue.abandon();
      throw;
    }
  });
  summary.threads = granted;
  if (!shared) summary.calibration = calibrating.calibration();
  summary.cells_done = queue.cells_done();
  summary.stopped = !queue.complete();
  summary.wall_seconds = seconds_since(start);
  return summary;
}

SweepSummary run_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                       const MethodRegistry& methods, RecordSink& sink, const std::set<std::uint64_t>& done,
                       const SweepHooks& hooks) {
  return run_sweep(experiment, generators, methods, sink, DoneCells(done), hooks, SweepShare());
}

}  // namespace raygauge
