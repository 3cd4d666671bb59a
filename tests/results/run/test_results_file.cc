// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/results_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "results/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::test_results_file {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

TEST(ResultsFile, EveryRecordComesBackBitByBit) {
  const TemporaryFolder folder;
  const ResultsFile written = sample_results(small_experiment());
  write_results(folder.file("x.h5"), written);
  const ResultsFile read = read_results(folder.file("x.h5"));
  EXPECT_EQ(fingerprints(read.records), fingerprints(written.records));
  EXPECT_TRUE(read.finished());
}

TEST(ResultsFile, RecordsOfManyChunksComeBack) {
  const TemporaryFolder folder;
  ResultsFile written = sample_results(small_experiment());
  const std::vector<Record> few = written.records;
  constexpr std::size_t kMoreThanTwoChunks = 40000;
  for (std::size_t i = 0; written.records.size() < kMoreThanTwoChunks; ++i) {
    Record& copy = written.records.emplace_back(few[i % few.size()]);
    copy.cell = 1000 + i;
    copy.seconds = 1e-3 * static_cast<double>(i);
    copy.generator_parameters = "separation=" + std::to_string(i / 10000);
  }
  write_results(folder.file("x.h5"), written);
  EXPECT_EQ(fingerprints(read_results(folder.file("x.h5")).records), fingerprints(written.records));
}

TEST(ResultsFile, AFileThatIsReplacedIsCheckedAnew) {
  const TemporaryFolder folder;
  const std::string path = folder.file("x.h5");
  const ResultsFile written = sample_results(small_experiment());
  write_results(path, written);
  EXPECT_EQ(read_results(path).records.size(), written.records.size());
  write_results(path, ResultsFile());
  EXPECT_TRUE(read_results(path).records.empty());
  std::string damaged = read_bytes(path);
  damaged[damaged.size() / 2] ^= 1;
  write_bytes(path, damaged);
  EXPECT_THROW(read_results(path), ResultsError);
}

TEST(ResultsFile, ProvenanceComesBack) {
  const TemporaryFolder folder;
  ResultsFile written = sample_results(small_experiment());
  written.provenance.sessions.emplace_back();
  write_results(folder.file("x.h5"), written);
  const Provenance read = read_results(folder.file("x.h5")).provenance;
  EXPECT_EQ(read.experiment_text, written.provenance.experiment_text);
  EXPECT_EQ(read.identity, written.provenance.identity);
  EXPECT_EQ(read.cell_count, written.provenance.cell_count);
  ASSERT_EQ(read.sessions.size(), 2U);
  const Session& session = read.sessions[0];
  const Session expected = sample_session();
  EXPECT_EQ(session.build.compiler_flags, expected.build.compiler_flags);
  EXPECT_TRUE(session.build.git_dirty);
  EXPECT_EQ(session.machine.memory_bytes, expected.machine.memory_bytes);
  EXPECT_EQ(session.finished_at, expected.finished_at);
  ASSERT_EQ(session.versions.size(), 2U);
  EXPECT_EQ(session.versions[1].version, "5.0");
  ASSERT_EQ(session.calibration.entries.size(), 2U);
  EXPECT_EQ(session.calibration.threads, 2);
  EXPECT_EQ(session.calibration.entries[1].method, expected.calibration.entries[1].method);
  EXPECT_EQ(session.calibration.entries[0].slowdown, 1.1);
  EXPECT_TRUE(read.sessions[1].versions.empty());
  EXPECT_TRUE(read.sessions[1].calibration.entries.empty());
}

TEST(ResultsFile, TheSameResultsGiveTheSameBytes) {
  const TemporaryFolder folder;
  write_results(folder.file("a.h5"), sample_results(small_experiment()));
  write_results(folder.file("b.h5"), sample_results(small_experiment()));
  EXPECT_EQ(read_bytes(folder.file("a.h5")), read_bytes(folder.file("b.h5")));
}

TEST(ResultsFile, RecordsAreSortedAsByAStableSort) {
  std::mt19937 generator(1);
  for (int size = 0; size < 40; ++size) {
    std::vector<Record> records;
    for (int i = 0; i < size; ++i) {
      Record record;
      record.cell = generator() % 5;
      record.repetition = static_cast<int>(generator() % 3);
      record.method = std::to_string(i);  // none is repeated
      records.push_back(record);
    }
    std::vector<Record> expected = records;
    std::stable_sort(expected.begin(), expected.end(), [](const Record& a, const Record& b) {
      return std::pair(a.cell, a.repetition) < std::pair(b.cell, b.repetition);
    });
    sort_by_cell(records);
    ASSERT_EQ(records.size(), expected.size());
    for (std::size_t i = 0; i < records.size(); ++i) EXPECT_EQ(records[i].method, expected[i].method);
  }
}

TEST(ResultsFile, ARunWithoutRecordsIsAFileToo) {
  const TemporaryFolder folder;
  write_results(folder.file("x.h5"), ResultsFile());
  EXPECT_TRUE(read_results(folder.file("x.h5")).records.empty());
}

}  // namespace
}  // namespace raygauge::test_results_file
