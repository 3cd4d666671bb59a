// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A results file, by the bytes: it is read or refused, and what is read can be written and read again.
#include "results/exceptions.h"
#include "results/results_file.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/scratch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace raygauge;
  static const fuzz::ScratchFile file(".h5"), copy(".copy.h5");
  file.write(fuzz::as_text(data, size));
  ResultsFile results;
  bool is_read = false;
  fuzz::expect_success_or_error([&] {
    results = read_results(file.path());
    is_read = true;
  });
  if (!is_read) return 0;
  write_results(copy.path(), results);
  const ResultsFile again = read_results(copy.path());
  fuzz::require(again.records.size() == results.records.size() &&
                    again.provenance.identity == results.provenance.identity &&
                    again.provenance.sessions.size() == results.provenance.sessions.size(),
                "results written and read again are the same");
  return 0;
}
