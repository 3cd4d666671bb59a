// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "raygauge/sweep/record.h"
#include "results/provenance/provenance.h"

namespace raygauge {

/// What a results file holds.
struct ResultsFile {
  std::vector<Record> records;  ///< by cell, then repetition, then method in the order of the experiment
  Provenance provenance;

  /// The cells that are stored whole.
  std::set<std::uint64_t> cells() const;

  /// Whether every cell of the grid has been done.
  bool finished() const { return cells().size() == provenance.cell_count; }
};

/// Into the order of a results file, of one order within repetitions; of the same solves the first one stays.
void sort_by_cell(std::vector<Record>& records);

/// The results at `path` or what it is a link to: the file, the parts of a run that is unfinished or still
/// going on, or both; the records of a cell that is in both are the file's. Throws ResultsError for a file
/// that is missing, not HDF5, truncated or not raygauge's, and SchemaVersionError for another schema version.
ResultsFile read_results(const std::string& path);

/// Throws ResultsError unless `path` is an undamaged HDF5 file or there are parts of an unfinished run.
void require_results(const std::string& path);

/// Writes `results` as one self-describing file, aside first and renamed when complete: `path` is never seen
/// half-written. Throws ResultsError (the message carries the system's reason).
void write_results(const std::string& path, const ResultsFile& results);

}  // namespace raygauge
