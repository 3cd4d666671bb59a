// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A journal of cells, by the bytes: it is read or refused, and what is read can be written and read again.
#include <map>

#include "results/cell_journal.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {
namespace {

/// Whether writing the cells and reading them again gives as many records.
bool survive(const std::vector<Record>& records, const std::string& path) {
  std::map<std::uint64_t, std::vector<Record>> cells;
  for (const Record& record : records) cells[record.cell].push_back(record);
  CellJournal journal(path);
  for (const auto& [cell, part] : cells) journal.append(cell, part);
  return read_cell_journal(path).size() == records.size();
}

}  // namespace

void check_cell_journal(std::string_view input) {
  static const ScratchFile file(".csv"), copy(".copy.csv");
  file.write(input);
  expect_success_or_error([&] {
    require(survive(read_cell_journal(file.path()), copy.path()),
            "cells written and read again are the same");
  });
}

}  // namespace raygauge::fuzz
