// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A journal of cells, by the bytes: it is read or refused, and what is read can be written and read again.
#include <map>
#include <optional>

#include "results/journal/cell_journal.h"
#include "results/journal/csv.h"
#include "results/run/results_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {
namespace {

std::vector<Record> written_and_read_again(const std::vector<Record>& records, const std::string& path) {
  std::map<std::uint64_t, std::vector<Record>> cells;
  for (const Record& record : records) cells[record.cell].push_back(record);
  CellJournal journal(path);
  for (const auto& [cell, part] : cells) journal.append(cell, part);
  return read_cell_journal(path);
}

std::string sorted_rows(std::vector<Record> records) {
  sort_by_cell(records);
  return csv_rows(records);
}

}  // namespace

void check_cell_journal(std::string_view input) {
  static const ScratchFile file(".csv"), copy(".copy.csv");
  file.write(input);
  std::optional<std::vector<Record>> records;
  expect_success_or_error([&] { records = read_cell_journal(file.path()); });
  if (!records) return;
  require(sorted_rows(written_and_read_again(*records, copy.path())) == sorted_rows(*records),
          "cells written and read again are the same");
}

}  // namespace raygauge::fuzz
