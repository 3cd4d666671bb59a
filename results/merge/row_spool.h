// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/merge/row_layout.h"

namespace raygauge {

/// Consecutive rows of the spool: repetitions first, …, last of a cell, from one part.
struct RowRun {
  std::uint64_t cell = 0;
  int first = 0;
  int last = 0;
  std::uint32_t part = 0;
  std::uint32_t rows = 0;
  std::uint64_t row = 0;  ///< the first, in the spool
};

/// Rows of all parts one after another in a file without a name, which goes when the object goes.
class RowSpool {
 public:
  /// In the folder of `beside`. Throws ResultsError.
  explicit RowSpool(const std::filesystem::path& beside);
  ~RowSpool();
  RowSpool(const RowSpool&) = delete;
  RowSpool& operator=(const RowSpool&) = delete;

  RowLayout& layout() noexcept { return layout_; }
  std::vector<RowRun>& runs() noexcept { return runs_; }

  /// Appends the rows of a part, whose runs may go on from those of the call before.
  void append(std::uint32_t part, const std::vector<char>& rows);

  /// Reads `count` rows from `first` on to `rows`.
  void read(std::uint64_t first, std::size_t count, char* rows) const;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  RowLayout layout_;
  std::vector<RowRun> runs_;
  std::uint64_t size_ = 0;  ///< rows
};

}  // namespace raygauge
