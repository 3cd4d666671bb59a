// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/merge/column_reader.h"
#include "results/merge/row_block.h"
#include "results/merge/row_spool.h"
#include "results/run/results_file.h"

namespace raygauge {

/// Rows that are read and written together: those of a chunk of a column.
inline constexpr std::size_t kRowsAtOnce = 16384;

/// Appends records of one part after another to a spool.
class RowReader {
 public:
  explicit RowReader(RowSpool& spool);

  /// Those of a results file, a chunk at a time, their sessions raised by `first_session`. Throws
  /// ResultsError.
  void add_file(const std::filesystem::path& path, std::uint32_t part, int first_session);

  /// The same of records in memory.
  void add_records(const std::vector<Record>& records, std::uint32_t part, int first_session);

 private:
  void read_block(hsize_t first, hsize_t count);

  RowSpool& spool_;
  std::vector<ColumnReader> columns_;  ///< by field
  RowBlock block_;
  std::vector<char> rows_;
};

/// Writes the rows of `runs`, in that order, as a results file: aside first and renamed when complete.
void write_rows(const std::filesystem::path& path, const Provenance& provenance,
                const std::vector<RowRun>& runs, RowSpool& spool);

}  // namespace raygauge
