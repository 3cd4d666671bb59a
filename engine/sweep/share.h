// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/sweep/pieces.h"
#include "raygauge/sweep.h"

namespace raygauge {

/// The part of a sweep that one process does, if it does not do it all alone.
struct SweepShare {
  Shard shard;  ///< only these pieces

  /// Processes that work on the same list of pieces at the same time, this one included; with more than one
  /// all of the following are set, and `workers` counts the threads of them all.
  int processes = 1;
  int workers = 1;
  PieceCounter* counter = nullptr;
  int threads = 0;                          ///< of this process
  int concurrency = 0;                      ///< threads on this machine, those of other processes included
  std::optional<std::vector<int>> cpus;     ///< where this process pins its threads; empty: nowhere
  bool calibrates = false;                  ///< for its machine, while the others wait
  std::function<void()> wait_for_the_rest;  ///< returns when all processes have called it
};

/// The pieces of the experiment that are to be done: all that `done` lacks, of one shard if that is the
/// share.
std::vector<CellPiece> pieces_to_do(const Experiment& experiment, const std::vector<Cell>& grid,
                                    const DoneCells& done, const SweepShare& share);

/// run_sweep() of the pieces of a share: of a shard, or of those that other processes do not take. Cells that
/// are split (see pieces_of()) are stored piece by piece.
SweepSummary run_sweep(const Experiment& experiment, const GeneratorRegistry& generators,
                       const MethodRegistry& methods, RecordSink& sink, const DoneCells& done,
                       const SweepHooks& hooks, const SweepShare& share);

}  // namespace raygauge
