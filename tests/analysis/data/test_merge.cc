// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/merge.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "results/exceptions.h"
#include "results/run/results_file.h"
#include "tests/analysis/records.h"
#include "tests/results/support.h"

namespace raygauge::test_merge {
namespace {

using testing::message_of;

class Merge : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const ResultsFile& results) const {
    const std::string path = folder_.file(name);
    write_results(path, results);
    return path;
  }

  static ResultsFile run(const std::string& started_at) {
    ResultsFile results = testing::sample_results(testing::small_experiment());
    results.provenance.sessions.resize(1);
    results.provenance.sessions[0].started_at = started_at;
    results.provenance.sessions[0].timing = "serial";
    return results;
  }

  testing::TemporaryFolder folder_;
};

TEST_F(Merge, JoinsTheRecordsOfSeveralRuns) {
  const ResultsFile first = run("2026-01-01T00:00:00Z");
  const MergedResults merged =
      read_merged({write("a.h5", first), write("b.h5", run("2026-01-02T00:00:00Z"))});
  EXPECT_EQ(merged.records.size(), 2 * first.records.size());
  EXPECT_TRUE(merged.notes.empty());
}

TEST_F(Merge, RefusesTheSameRunTwice) {
  const std::string a = write("a.h5", run("2026-01-01T00:00:00Z"));
  const std::string copy = write("copy.h5", run("2026-01-01T00:00:00Z"));
  EXPECT_EQ(message_of<InvalidParameterError>([&] {
              read_merged({a, copy});
            }),
            copy + " holds the same run as " + a);
}

TEST_F(Merge, NotesWhatItsReadersShouldKnow) {
  ResultsFile first = run("2026-01-01T00:00:00Z");
  first.provenance.cell_count += 1;
  Session& session = first.provenance.sessions[0];
  session.timing = "parallel";
  session.threads = 4;
  session.calibration.threads = 4;
  session.calibration.entries = {{"column_generation", 1, 1.25, 1.25}};
  ResultsFile second = run("2026-01-02T00:00:00Z");
  second.provenance.sessions[0].machine.cpu_model = "another processor";
  const std::string a = write("a.h5", first);
  const MergedResults merged = read_merged({a, write("b.h5", second)});
  ASSERT_EQ(merged.notes.size(), 3U);
  EXPECT_EQ(merged.notes[0], a + ": unfinished, 4 of 5 cells");
  EXPECT_EQ(merged.notes[1],
            a + ": timed with 4 threads at once; slowdown of single solves: column_generation 1.25");
  EXPECT_TRUE(merged.notes[2].starts_with("times from different processors are mixed: ")) << merged.notes[2];
}

TEST_F(Merge, NotesThatTimesComeFromDifferentMachines) {
  ResultsFile results = run("2026-01-01T00:00:00Z");
  Session& first = results.provenance.sessions[0];
  first.timing = "parallel";
  first.calibration = {2, {{"column_generation", 1, 1.25, 1.25}}};
  Session second = first;
  second.machine.hostname = "other";
  second.calibration.entries[0].slowdown = 1.5;
  results.provenance.sessions.push_back(second);
  const std::string path = write("a.h5", results);
  const MergedResults merged = read_merged({path});
  ASSERT_EQ(merged.notes.size(), 2U);
  EXPECT_EQ(merged.notes[0], path +
                                 ": timed with 2 threads at once; slowdown of single solves: "
                                 "on host column_generation 1.25; on other column_generation 1.50");
  EXPECT_EQ(merged.notes[1], "times from different machines are mixed: host, other, each with A processor");
}

TEST(HostWords, NameTheFirstFewOfMany) {
  EXPECT_EQ(host_words({"a", "b"}), "a, b");
  EXPECT_EQ(host_words({"a", "b", "c", "d", "e", "f"}), "a, b, c, d and 2 more");
}

TEST_F(Merge, NamesAFileThatIsMissing) {
  EXPECT_NE(message_of<ResultsError>([&] { read_merged({folder_.file("none.h5")}); }).find("none.h5"),
            std::string::npos);
}

}  // namespace
}  // namespace raygauge::test_merge
