// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/sweep/schedule.h"

namespace raygauge {
namespace {

/// In how many pieces a cell is done.
int piece_count(const Experiment& experiment, const Cell& cell, double fair_share) {
  if (experiment.stop_when_within > 0 || expected_cost(cell) <= fair_share) return 1;
  const double halves = std::ceil(2 * expected_cost(cell) / fair_share);
  return static_cast<int>(std::min<double>(halves, experiment.repetitions));
}

/// The repetitions of all pieces of a cell, ranges [first, last) of nearly the same length.
std::vector<std::pair<int, int>> ranges_of(int repetitions, int pieces) {
  std::vector<std::pair<int, int>> ranges;
  for (std::int64_t i = 0; i < pieces; ++i) {
    ranges.emplace_back(static_cast<int>(i * repetitions / pieces),
                        static_cast<int>((i + 1) * repetitions / pieces));
  }
  return ranges;
}

double total_cost(const std::vector<Cell>& cells) {
  return std::accumulate(cells.begin(), cells.end(), 0.0,
                         [](double sum, const Cell& cell) { return sum + expected_cost(cell); });
}

/// Adds what is missing of repetitions [range.first, range.second).
void add_missing(const Cell& cell, std::pair<int, int> range, const DoneCells& done, int repetitions,
                 std::vector<CellPiece>& pieces) {
  for (const auto& [first, last] : done.missing(cell.index, repetitions)) {
    const int begin = std::max(first, range.first);
    const int end = std::min(last, range.second);
    if (begin < end) pieces.push_back({cell, begin, end});
  }
}

}  // namespace

void DoneCells::add_whole(std::uint64_t cell) {
  partial_.erase(cell);
  whole_.insert(cell);
}

void DoneCells::add(std::uint64_t cell, int repetition, int repetitions) {
  if (whole_.count(cell) != 0) return;
  std::set<int>& stored = partial_[cell];
  stored.insert(repetition);
  if (stored.size() >= static_cast<std::size_t>(repetitions)) add_whole(cell);
}

std::vector<std::pair<int, int>> DoneCells::missing(std::uint64_t cell, int repetitions) const {
  if (whole_.count(cell) != 0) return {};
  const auto found = partial_.find(cell);
  if (found == partial_.end()) return {{0, repetitions}};
  std::vector<std::pair<int, int>> ranges;
  int first = 0;
  for (const int stored : found->second) {
    if (first < stored) ranges.emplace_back(first, stored);
    first = stored + 1;
  }
  if (first < repetitions) ranges.emplace_back(first, repetitions);
  return ranges;
}

std::vector<CellPiece> pieces_of(const Experiment& experiment, const std::vector<Cell>& cells,
                                 const DoneCells& done, int workers) {
  const double fair_share = total_cost(cells) / workers;
  std::vector<CellPiece> pieces;
  for (const Cell& cell : cells) {
    const int count = workers > 1 ? piece_count(experiment, cell, fair_share) : 1;
    for (const auto& range : ranges_of(experiment.repetitions, count)) {
      add_missing(cell, range, done, experiment.repetitions, pieces);
    }
  }
  return pieces;
}

std::vector<CellPiece> pieces_of_shard(const Experiment& experiment, const std::vector<Cell>& grid,
                                       const DoneCells& done, const Shard& shard) {
  const std::vector<Cell> cells = longest_first(grid, experiment.shuffle, experiment.seed);
  std::vector<CellPiece> pieces;
  std::uint64_t number = 0;
  for (const CellPiece& piece : pieces_of(experiment, cells, {}, shard.count)) {
    if (number++ % static_cast<std::uint64_t>(shard.count) != static_cast<std::uint64_t>(shard.index) - 1) {
      continue;
    }
    add_missing(piece.cell, {piece.first, piece.last}, done, experiment.repetitions, pieces);
  }
  return pieces;
}

}  // namespace raygauge
