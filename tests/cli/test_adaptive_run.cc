// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// `raygauge run --stop-when-within`, as a user runs it. How often a cell is repeated depends on times; that
// it was repeated as often as its own stored times ask for does not.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <set>
#include <span>

#include "engine/sweep/repetitions.h"
#include "results/run/results_file.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::test_adaptive_run {
namespace {

using testing::ProgramResult;

const std::string kExperiment = testing::example2_experiment(
    "name = \"adaptive\"\n", "n = [3, 4]\nN = [20, 30, 40]\nrepetitions = 60\nmin_repetitions = 8\n");
constexpr std::size_t kMethods = 2;

/// What the file above with the option below comes to.
Experiment rule() {
  Experiment experiment;
  experiment.repetitions = 60;
  experiment.min_repetitions = 8;
  experiment.stop_when_within = 0.3;
  return experiment;
}

/// Repetitions of a cell by the rule, seen from the times that were stored.
std::size_t repetitions_asked_for(std::span<const Record> records) {
  const Experiment experiment = rule();
  int done = 0;
  do {
    done = next_look(experiment, done);
    if (kMethods * static_cast<std::size_t>(done) >= records.size()) break;
  } while (!medians_known(records.first(kMethods * static_cast<std::size_t>(done)), kMethods,
                          experiment.stop_when_within));
  return static_cast<std::size_t>(done);
}

class AdaptiveRun : public testing::ProgramTest {
 protected:
  void SetUp() override { write("adaptive.toml", kExperiment); }

  static std::vector<std::string> arguments(const std::vector<std::string>& more) {
    std::vector<std::string> all = {"run", "adaptive.toml", "-o", "x.h5", "--stop-when-within", "0.3"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// Expects all cells, each record once, and each cell to end where its times say.
  void expect_whole() const {
    const ResultsFile results = read_results(folder_.file("x.h5"));
    EXPECT_TRUE(results.finished());
    std::map<std::uint64_t, std::vector<Record>> cells;
    for (const Record& record : results.records) cells[record.cell].push_back(record);
    EXPECT_EQ(cells.size(), 6u);
    for (const auto& [index, records] : cells) {
      for (std::size_t i = 0; i < records.size(); ++i) {
        EXPECT_EQ(records[i].repetition, static_cast<int>(i / kMethods)) << "cell " << index;
        EXPECT_EQ(records[i].method, i % kMethods == 0 ? "column_generation" : "zheng_yamane");
      }
      const std::size_t repetitions = records.size() / kMethods;
      EXPECT_EQ(repetitions, repetitions_asked_for(records)) << "cell " << index;
      const bool known = medians_known(records, kMethods, rule().stop_when_within);
      EXPECT_TRUE(known || repetitions == 60) << "cell " << index;
    }
  }
};

TEST_F(AdaptiveRun, RepeatsEachCellAsOftenAsItsOwnTimesAskFor) {
  for (const char* threads : {"1", "2"}) {
    const ProgramResult result = run_raygauge(arguments({"--force", "--threads", threads}));
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.out.find("  repeated   "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(" of 6 cells ran to the limit\n"), std::string::npos);
    expect_whole();
  }
}

TEST_F(AdaptiveRun, TheResultsTellTheRule) {
  ASSERT_EQ(run_raygauge(arguments({"--quiet"})).status, 0);
  const Provenance provenance = read_results(folder_.file("x.h5")).provenance;
  EXPECT_TRUE(provenance.experiment_text.starts_with("# adaptive.toml --set sweep.stop_when_within=0.3\n"));
  EXPECT_NE(provenance.experiment_text.find("\nstop_when_within = "), std::string::npos);
  EXPECT_NE(provenance.identity.find("min_repetitions = 8\nstop_when_within = 0.3\n"), std::string::npos);
}

TEST_F(AdaptiveRun, InterruptedOrKilledAndResumedHasEveryRecordOnce) {
  const std::vector<std::string> more = {"--set", "run.min_seconds=2e-3", "--resume"};
  for (const int signal : {SIGTERM, SIGKILL, SIGINT}) {
    testing::Program program(folder_.path(), arguments(more));
    ASSERT_TRUE(program.comes_to_handle(SIGTERM));
    program.signal(signal);
    EXPECT_EQ(program.wait().status, 128 + signal);
  }
  const ProgramResult result = run_raygauge(arguments(more));
  ASSERT_EQ(result.status, 0) << result.err;
  expect_whole();
}

TEST_F(AdaptiveRun, InterruptedItTellsTheWholeCommandThatContinues) {
  testing::Program program(folder_.path(), arguments({"--set", "run.min_seconds=0.02"}));
  ASSERT_TRUE(program.comes_to_handle(SIGTERM));
  program.signal(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.status, 130);
  EXPECT_NE(result.err.find(" run adaptive.toml -o x.h5 --set run.min_seconds=0.02 "
                            "--set sweep.stop_when_within=0.3 --resume\n"),
            std::string::npos)
      << result.err;
}

TEST_F(AdaptiveRun, IsNotResumedByAnotherRule) {
  ASSERT_EQ(run_raygauge(arguments({"--quiet"})).status, 0);
  testing::expect_complaint(
      run_raygauge({"run", "adaptive.toml", "-o", "x.h5", "--stop-when-within", "0.1", "--resume"}),
      "raygauge: x.h5: holds another experiment: stop_when_within = 0.3 there, 0.1 here");
  testing::expect_complaint(
      run_raygauge({"run", "adaptive.toml", "-o", "x.h5", "--resume"}),
      "raygauge: x.h5: holds another experiment: min_repetitions = 8 there, nothing here (and 1 more)");
}

TEST_F(AdaptiveRun, DryRunSaysAtMost) {
  const ProgramResult result = run_raygauge(arguments({"--dry-run", "--threads", "1"}));
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("instances    at most 360 (8 to 60 a cell, until the medians are known within "
                            "30 %, seed 1)\n"),
            std::string::npos)
      << result.out;
  EXPECT_NE(result.out.find("solves       at most 720 timed"), std::string::npos);
  EXPECT_NE(result.out.find("estimate     at most about "), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("x.h5")));
}

TEST_F(AdaptiveRun, BadFractionsAreRefused) {
  const auto refused = [this](const std::string& fraction, const std::string& line) {
    testing::expect_complaint(run_raygauge({"run", "adaptive.toml", "--stop-when-within", fraction}), line);
  };
  refused("2", "raygauge: --set sweep.stop_when_within=2: sweep.stop_when_within must lie in [0, 1], got 2");
  refused("-0.1",
          "raygauge: --set sweep.stop_when_within=-0.1: sweep.stop_when_within must lie in [0, 1], got -0.1");
  refused("nan",
          "raygauge: --set sweep.stop_when_within=nan: sweep.stop_when_within must lie in [0, 1], got nan");
  EXPECT_EQ(run_raygauge({"run", "adaptive.toml", "--stop-when-within", "tight"}).status, 2);
  testing::expect_complaint(
      run_raygauge({"run", "adaptive.toml", "--stop-when-within", "0.1", "--set", "sweep.repetitions=7"}),
      "raygauge: adaptive.toml:2: stop_when_within needs repetitions of at least min_repetitions, 8, got 7");
}

}  // namespace
}  // namespace raygauge::test_adaptive_run
