// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "results/merge/row_spool.h"
#include "results/run/results_file.h"

namespace raygauge {

/// Rows that are read and written together: those of a chunk of a column.
inline constexpr std::size_t kRowsAtOnce = 16384;

/// Appends the records of a results file to the spool, a chunk at a time, their sessions raised by
/// `first_session`.
void spool_file(const std::filesystem::path& path, std::uint32_t part, int first_session, RowSpool& spool);

/// The same of records in memory.
void spool_records(const std::vector<Record>& records, std::uint32_t part, int first_session,
                   RowSpool& spool);

/// Writes the rows of `runs`, in that order, as a results file: aside first and renamed when complete.
void write_rows(const std::filesystem::path& path, const Provenance& provenance,
                const std::vector<RowRun>& runs, RowSpool& spool);

}  // namespace raygauge
