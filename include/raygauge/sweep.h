// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

// The public interface of the library raygauge::sweep: experiments, run over many instances by many methods.
#if __cplusplus < 201709L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#error "raygauge needs C++20: compile with -std=c++20"
#else
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>

#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/instance.h"
#include "raygauge/sweep/method.h"
#include "raygauge/sweep/record.h"
#include "raygauge/sweep/registry.h"

namespace raygauge {

/// The slowdown of single solves while all threads are busy: per method, the median over
/// instances of the calibration cell of (time in the sweep, all threads busy) / (time alone, before it).
struct Calibration {
  struct Entry {
    std::string method;
    double serial_seconds = 0;    ///< median
    double parallel_seconds = 0;  ///< median
    double slowdown = 1;          ///< median ratio
    /// 95 % interval of that median: [0, inf] where there are fewer than 6 instances, NaN where it is not
    /// known.
    double slowdown_lower = std::numeric_limits<double>::quiet_NaN();
    double slowdown_upper = std::numeric_limits<double>::quiet_NaN();

    /// Whether the slowdown may be noise: 1 lies within its interval.
    bool is_noise() const { return slowdown_lower <= 1 && slowdown_upper >= 1; }
  };
  int threads = 1;
  std::vector<Entry> entries;
};

/// Progress, told after every finished cell, from whichever thread finished it, one call at a time.
struct SweepProgress {
  std::uint64_t cells_done = 0;  ///< of this call, resumed ones not counted
  std::uint64_t cells_total = 0;
  double elapsed_seconds = 0;
  double remaining_seconds = 0;  ///< estimate from the work done so far
};

struct SweepHooks {
  std::function<void(const SweepProgress&)> progress;

  /// Called before each timed solve and each cell, by several threads at once. Once it returns true, the
  /// sweep ends after the running samples. Unfinished cells are dropped: a cell is measured in one go, so
  /// that a disturbance falls on all its methods alike.
  std::function<bool()> stop;

  /// Takes every sample, of the calibration too; from any thread, several at once.
  SolveTimer time = time_solve;

  bool stop_asked() const { return stop && stop(); }
};

/// Result of a sweep.
struct SweepSummary {
  int threads = 1;
  std::uint64_t cells_done = 0;  ///< of this call, resumed ones not counted
  bool stopped = false;          ///< by SweepHooks::stop, with cells left to do
  double wall_seconds = 0;       ///< calibration included
  Calibration calibration;  ///< empty for TimingMode::serial, one thread, nothing to do or stopped before
                            ///< its cell was done
};

/// How many threads a sweep of `cells` cells starts: one for TimingMode::serial, else Experiment::threads (0:
/// one for each CPU that the process may use), but no more than there are cells.
int sweep_threads(const Experiment& experiment, std::size_t cells);

/// Runs every cell of the experiment that is not in `done`, storing each in `sink` as it finishes. The
/// records are the same (except for times, inner repetitions and threads) for any thread count and any order;
/// with Experiment::stop_when_within > 0 how many repetitions a cell has depends on its times. An exception
/// of a generator, a method or the sink ends the sweep after the cells in flight and is rethrown.
SweepSummary run_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                       const MethodRegistry& methods, RecordSink& sink,
                       const std::set<std::uint64_t>& done = {}, const SweepHooks& hooks = {});

}  // namespace raygauge
#endif
