// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/record.h"
#include "results/run/results_file.h"

namespace raygauge::testing {

/// A new folder that is removed, with all it holds, at the end of the test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string path() const { return path_.string(); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// A grid of `cell_count` cells (one for each N), two methods, `repetitions` instances a cell.
Experiment small_experiment(int cell_count = 4, int repetitions = 3);

/// What a sweep would store for a cell of small_experiment: a function of the cell alone, times included,
/// with the methods in an order that is not the experiment's, and NaN in two patterns.
CellResult cell_result(const Experiment& experiment, std::uint64_t cell);

/// A session with every field set.
Session sample_session();

/// The whole run of an experiment, as it should read: NaN in one pattern.
ResultsFile sample_results(const Experiment& experiment);

/// Every column of a record but its session, doubles bit by bit: equal texts are equal records.
std::string fingerprint(const Record& record);
std::vector<std::string> fingerprints(const std::vector<Record>& records);

std::string read_bytes(const std::string& path);
void write_bytes(const std::string& path, const std::string& bytes);

/// Names of the entries of a folder, sorted.
std::vector<std::string> entries_of(const std::string& folder);

/// The message of the Error that `call` throws; "" if it throws none.
template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace raygauge::testing
