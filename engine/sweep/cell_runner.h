// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "engine/sweep/pieces.h"
#include "engine/sweep/sweep_plan.h"
#include "raygauge/sweep.h"
#include "raygauge/sweep/method.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// How many of so many repetitions are held in memory at once: at least one, at most 4096 with 256 MB of
/// points.
int batch_size(const Cell& cell, int repetitions);

/// Runs cells on one thread, with method objects of its own.
///
/// Within a cell all methods meet all repetitions in a seeded random order, so that a slow drift of the
/// machine falls on every method alike. Cells too large to be held in memory at once are taken in batches of
/// repetitions, interleaved within each; so are the blocks between the looks of Experiment::stop_when_within.
class CellRunner {
 public:
  /// Where and when the records come about; copied into them.
  struct Circumstances {
    int thread = 0;
    int concurrency = 1;
    SteadyClock::time_point sweep_start = SteadyClock::now();
  };

  /// Create, use and destroy it in one thread. `plan` outlives it.
  CellRunner(const SweepPlan& plan, const Circumstances& circumstances, SweepHooks hooks = {});

  /// Records in the order (repetition, method), whatever the order they were made in: of every repetition, or
  /// of those up to the look (next_look()) at which medians_known() holds. Empty if SweepHooks::stop cut the
  /// cell short. Throws what the generator or a method throws.
  std::optional<CellResult> run(const Cell& cell);

  /// The same of a piece of a cell; of a whole cell as run().
  std::optional<CellResult> run(const CellPiece& piece);

  /// The same of so many first repetitions.
  std::optional<CellResult> run_first(const Cell& cell, int repetitions);

 private:
  Record blank_record(const Cell& cell, int repetition, std::size_t method) const;
  void load(std::size_t method, const Instance& instance, const SolveRequest& request);
  void warm_up(const Cell& cell, const Instance& instance);
  /// These append the records of repetitions first, …, last - 1; false if the sweep was asked to stop. The
  /// methods are warmed up where `records` are empty.
  bool run_block(const Cell& cell, int first, int last, std::vector<Record>& records);
  bool run_batch(const Cell& cell, int first, int last, std::vector<Record>& records);
  void measure(const Cell& cell, const Instance& instance, std::size_t method, Record& record);

  const SweepPlan& plan_;
  Circumstances circumstances_;
  SweepHooks hooks_;
  std::vector<std::unique_ptr<SolveMethod>> methods_;
};

}  // namespace raygauge
