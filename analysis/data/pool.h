// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "analysis/data/cell_key.h"
#include "analysis/data/truth.h"
#include "raygauge/sweep/record.h"

namespace raygauge {

/// So many pairs of the user's own are still looked at one by one; more are a pool.
inline constexpr std::size_t kMostPairsApart = 8;

/// The user's own instances: the pairs of the generator `files`. Where there are more than kMostPairsApart,
/// each is an instance of one problem, and not a problem of its own.
class Pool {
 public:
  explicit Pool(const std::vector<Record>& records);

  /// 0 where the pairs are few, or there are none.
  std::size_t size() const noexcept { return pairs_.size(); }
  bool has(const Record& record) const;

  /// The records, those of the pool with "pairs=2000" as their parameters and a repetition for each pair and
  /// repetition.
  std::vector<Record> operator()(std::vector<Record> records) const;

  /// The truth of the records, under the names that they have in the pool.
  Truth truth_of(const std::vector<Record>& records) const;

 private:
  std::map<std::string, int> pairs_;  ///< by their parameters
  int repetitions_ = 1;
};

/// Whether the cell is of a Pool: its instances differ as the user's pairs do, and a mean over them is
/// geometric.
bool is_pool(const CellKey& cell);

}  // namespace raygauge
