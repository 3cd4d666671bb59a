// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A CSV file of pairs: what is accepted has as many cells in each line as columns, and poses that come back.
#include "cli/input/file_sets.h"
#include "cli/input/text_table.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_pair_list(std::string_view input) {
  static const ScratchFile file(".csv");
  file.write(input);
  expect_success_or_error([&] {
    const cli::TextTable table = cli::read_text_table(file.path());
    require(!table.rows.empty(), "an accepted table has rows");
    for (const cli::TextTable::Row& row : table.rows) {
      require(row.cells.size() == table.names.size(), "every row has every cell");
      for (const std::string& cell : row.cells) {
        expect_success_or_error([&] {
          const std::string text = cli::pose_text(cli::parse_pose(cell, row.place));
          require(cli::pose_text(cli::parse_pose(text, row.place)) == text, "the text of a pose comes back");
        });
      }
    }
  });
}

}  // namespace raygauge::fuzz
