// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/sweep/pieces.h"

namespace raygauge {

/// How long many workers take for a sweep whose cells' times are known.
struct Makespan {
  double seconds = 0;     ///< until the last piece is done
  double efficiency = 1;  ///< work / (workers × seconds)
  std::uint64_t pieces = 0;
  double longest = 0;          ///< the longest piece
  double counter_seconds = 0;  ///< that the shared counter is busy
};

/// Workers that take the next piece as they get free, from a counter that serves one at a time and takes
/// `counter_seconds` for each piece: ranks, or the threads of one process.
/// `cell_seconds`: of a whole cell with all methods and repetitions, by the index of the cell in the grid.
Makespan simulate_ranks(const Experiment& experiment, const std::vector<double>& cell_seconds,
                        std::uint64_t workers, double counter_seconds);

/// Shards, each with one worker, begun at the same time: what is dealt out beforehand stays.
Makespan simulate_shards(const Experiment& experiment, const std::vector<double>& cell_seconds, int shards);

}  // namespace raygauge
