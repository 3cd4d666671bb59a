// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/makespan.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

#include "engine/sweep/schedule.h"

namespace raygauge {
namespace {

/// A piece has its part of the cell's solves, and a warm-up of its own.
double seconds_of(const Experiment& experiment, const CellPiece& piece, double cell_seconds) {
  const double solves = experiment.repetitions + experiment.warmup;
  return cell_seconds * (piece.last - piece.first + experiment.warmup) / solves;
}

Makespan summary_of(const std::vector<double>& pieces, std::uint64_t workers, double end) {
  Makespan makespan;
  makespan.seconds = end;
  makespan.pieces = pieces.size();
  double work = 0;
  for (const double seconds : pieces) {
    work += seconds;
    makespan.longest = std::max(makespan.longest, seconds);
  }
  if (end > 0) makespan.efficiency = work / (static_cast<double>(workers) * end);
  return makespan;
}

}  // namespace

Makespan simulate_ranks(const Experiment& experiment, const std::vector<double>& cell_seconds,
                        std::uint64_t workers, double counter_seconds) {
  const std::vector<Cell> cells = longest_first(grid_of(experiment), experiment.shuffle, experiment.seed);
  const auto split_for = static_cast<int>(std::min<std::uint64_t>(workers, std::numeric_limits<int>::max()));
  std::vector<double> pieces;
  for (const CellPiece& piece : pieces_of(experiment, cells, {}, split_for)) {
    pieces.push_back(seconds_of(experiment, piece, cell_seconds.at(piece.cell.index)));
  }
  std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(workers, pieces.size()); ++i) free_at.push(0);
  double counter_free = 0;
  double end = 0;
  for (const double seconds : pieces) {
    counter_free = std::max(counter_free, free_at.top()) + counter_seconds;
    free_at.pop();
    end = std::max(end, counter_free + seconds);
    free_at.push(counter_free + seconds);
  }
  Makespan makespan = summary_of(pieces, workers, end);
  makespan.counter_seconds = counter_seconds * static_cast<double>(pieces.size());
  return makespan;
}

Makespan simulate_shards(const Experiment& experiment, const std::vector<double>& cell_seconds, int shards) {
  std::vector<double> pieces;
  double end = 0;
  const std::vector<Cell> cells = longest_first(grid_of(experiment), experiment.shuffle, experiment.seed);
  std::vector<double> ends(static_cast<std::size_t>(shards), 0.0);
  for (const CellPiece& piece : pieces_of(experiment, cells, {}, shards)) {
    const double seconds = seconds_of(experiment, piece, cell_seconds.at(piece.cell.index));
    double& own = ends[pieces.size() % ends.size()];
    own += seconds;
    end = std::max(end, own);
    pieces.push_back(seconds);
  }
  return summary_of(pieces, static_cast<std::uint64_t>(shards), end);
}

}  // namespace raygauge
