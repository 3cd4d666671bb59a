// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "raygauge/sweep/experiment.h"

namespace raygauge {

/// Repetitions first, …, last - 1 of a cell with all methods: what one thread does in one go. Most cells are
/// one piece. The methods meet on every instance of a piece, so their ratios are those of one core.
struct CellPiece {
  Cell cell;
  int first = 0;
  int last = 0;
};

/// Part `index` (from 1) of `count` parts of a sweep, which have every piece exactly once among them.
struct Shard {
  int index = 1;
  int count = 1;
};

/// Which repetitions of which cells are stored already.
class DoneCells {
 public:
  DoneCells() = default;
  explicit DoneCells(std::set<std::uint64_t> whole) : whole_(std::move(whole)) {}

  void add_whole(std::uint64_t cell);

  /// `repetitions` is what a whole cell has.
  void add(std::uint64_t cell, int repetition, int repetitions);

  const std::set<std::uint64_t>& whole() const noexcept { return whole_; }

  /// Stored repetitions of cells that are not whole.
  const std::map<std::uint64_t, std::set<int>>& partial() const noexcept { return partial_; }

  /// The ranges [first, last) of 0, …, repetitions - 1 that are not stored.
  std::vector<std::pair<int, int>> missing(std::uint64_t cell, int repetitions) const;

 private:
  std::set<std::uint64_t> whole_;
  std::map<std::uint64_t, std::set<int>> partial_;
};

/// The pieces of `cells`, in their order: of every cell what is missing, in one piece; a cell whose expected
/// cost is above a fair share (the cost of all / workers) in pieces of at most half a share each. A cell that
/// repeats adaptively is never split: when it ends depends on all its times.
std::vector<CellPiece> pieces_of(const Experiment& experiment, const std::vector<Cell>& cells,
                                 const DoneCells& done, int workers);

/// The pieces of a shard: of those of the whole grid, split for `shard.count` workers and counted in the
/// order of longest_first(), every shard.count-th; less what is done. The same on every machine, whatever is
/// done.
std::vector<CellPiece> pieces_of_shard(const Experiment& experiment, const std::vector<Cell>& grid,
                                       const DoneCells& done, const Shard& shard);

/// Deals out the numbers 0, 1, 2, … of a sweep's pieces to all who work on it: threads of one process, or of
/// many. All have the same list of pieces.
class PieceCounter {
 public:
  virtual ~PieceCounter() = default;

  /// A number that nobody else gets. Thread safe.
  virtual std::uint64_t next() = 0;

  /// Counts a piece as stored and returns how many are, of all workers. Thread safe.
  virtual std::uint64_t finish() = 0;

  /// No more pieces for anyone: all further numbers lie beyond the list. Thread safe.
  virtual void abandon() = 0;
};

}  // namespace raygauge
