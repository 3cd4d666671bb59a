// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Rows of records as CSV, which in a journal a checksum keeps from the fuzzer: what is read can be written
// and read again.
#include <optional>

#include "results/journal/csv.h"
#include "tests/fuzz/harness.h"

namespace raygauge::fuzz {

void check_csv_rows(std::string_view input) {
  std::optional<std::string> rows;
  expect_success_or_error([&] { rows = csv_rows(read_csv_rows(input)); });
  if (rows) require(csv_rows(read_csv_rows(*rows)) == *rows, "rows written and read again are the same");
}

}  // namespace raygauge::fuzz
