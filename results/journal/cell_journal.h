// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/disk/atomic_file.h"

namespace raygauge {

/// The cells that one session has finished, in that order: CSV (see csv.h), each cell after a line that tells
/// where it ends.
///
///     # raygauge-results, schema version 3
///     cell,session,generator,…
///     # cell 12: 31234 bytes, CRC-32 1a2b3c4d
///     12,0,example2,…
///
/// One file that grows, and not one a cell: creating, synchronising and at last removing a file cost more
/// than a cell of a millisecond's solves, and what is removed at the end no second thread can help with.
class CellJournal {
 public:
  /// Creates the journal without cells. Throws ResultsError.
  explicit CellJournal(const std::filesystem::path& path);

  /// Durably appends the records of a cell, or of some repetitions of it. Thread safe. Throws ResultsError;
  /// cells stored before stay.
  void append(std::uint64_t cell, const std::vector<Record>& records);

 private:
  AppendedFile file_;
};

/// The records of the whole cells of a journal, cell by cell. A cell that is not whole, cut short by a kill
/// or damaged since, is left out, and thus not done. Throws ResultsError for a file that is no journal, and
/// SchemaVersionError for one of another schema version.
std::vector<Record> read_cell_journal(const std::filesystem::path& path);

}  // namespace raygauge
