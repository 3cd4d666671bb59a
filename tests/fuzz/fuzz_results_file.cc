// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A results file, by the bytes: it is read or refused, and what is read can be written and read again.
#include "results/exceptions.h"
#include "results/run/results_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

namespace raygauge::fuzz {

void check_results_file(std::string_view input) {
  static const ScratchFile file(".h5"), copy(".copy.h5");
  file.write(input);
  ResultsFile results;
  bool is_read = false;
  expect_success_or_error([&] {
    results = read_results(file.path());
    is_read = true;
  });
  if (!is_read) return;
  write_results(copy.path(), results);
  const ResultsFile again = read_results(copy.path());
  require(again.records.size() == results.records.size() &&
              again.provenance.identity == results.provenance.identity &&
              again.provenance.sessions.size() == results.provenance.sessions.size(),
          "results written and read again are the same");
}

}  // namespace raygauge::fuzz
