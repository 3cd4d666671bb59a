// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// `raygauge run` as a user runs it.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "results/run/results_file.h"
#include "tests/cli/program_fixture.h"

namespace raygauge::test_command_run {
namespace {

using testing::ProgramResult;
using testing::read_bytes;
using testing::write_bytes;

const std::string kExperiment = testing::example2_experiment(
    "name = \"small\"\n", "n = [3, 4]\nN = [20, 30]\nrepetitions = 2\n", "[run]\nthreads = 1\n");

class RunCommand : public ::testing::Test {
 protected:
  void SetUp() override { write_bytes(folder_.file("small.toml"), kExperiment); }

  ProgramResult run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "run");
    return testing::run_program(folder_.path(), arguments);
  }

  /// Runs what must be refused: exit status 2, nothing on standard output, one line on standard error, which
  /// is returned without the program's name.
  std::string refusal(const std::vector<std::string>& arguments) const {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    const std::string prefix = "raygauge: ";
    EXPECT_TRUE(result.err.starts_with(prefix)) << result.err;
    return result.err.substr(prefix.size(), result.err.size() - prefix.size() - 1);
  }

  /// The refusal of an experiment file of that text.
  std::string refusal_of_text(const std::string& text) const {
    write_bytes(folder_.file("bad.toml"), text);
    const std::string message = refusal({"bad.toml", "-o", "bad.h5"});
    EXPECT_FALSE(std::filesystem::exists(folder_.file("bad.h5")));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("bad.h5.parts")));
    return message;
  }

  /// Waits until the file is there; false if it does not come within a minute.
  bool appears(const std::string& name) const {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!std::filesystem::exists(folder_.file(name))) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
  }

  testing::TemporaryFolder folder_;
};

TEST_F(RunCommand, StoresEveryRecordWhereItSays) {
  const ProgramResult result = run({"small.toml"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("small: 4 cells"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("all methods agree on every instance"), std::string::npos);
  EXPECT_NE(result.out.find("results    out/small.h5"), std::string::npos);
  EXPECT_NE(result.out.find(" table out/small.h5 --rows n,N --cols method\n"), std::string::npos);
  const ResultsFile results = read_results(folder_.file("out/small.h5"));
  EXPECT_TRUE(results.finished());
  EXPECT_EQ(results.records.size(), 16u);
  EXPECT_EQ(results.provenance.experiment_text, kExperiment);
}

TEST_F(RunCommand, QuietPrintsNothing) {
  const ProgramResult result = run({"small.toml", "--quiet"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(RunCommand, ProgressIsPlainLinesWhereNobodyWatches) {
  const ProgramResult result = run({"small.toml"});
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 4) << result.err;
  EXPECT_NE(result.err.find("4 of 4 cells"), std::string::npos);
  EXPECT_EQ(result.err.find('\033'), std::string::npos);
  EXPECT_EQ(result.err.find('\r'), std::string::npos);
}

TEST_F(RunCommand, SetAndThreadsReplaceValues) {
  const ProgramResult result = run({"small.toml", "--set", "sweep.n=5", "--set", "sweep.N=20,40,60", "--set",
                                    "name=changed", "--threads", "2"});
  EXPECT_EQ(result.status, 0) << result.err;
  const ResultsFile results = read_results(folder_.file("out/changed.h5"));
  EXPECT_EQ(results.cells().size(), 3u);
  for (const Record& record : results.records) EXPECT_EQ(record.n, 5);
  EXPECT_EQ(results.provenance.sessions.front().threads, 2);
  EXPECT_EQ(results.provenance.sessions.front().calibration.entries.size(), 2u);
  EXPECT_NE(results.provenance.experiment_text.find("# small.toml --set sweep.n=5 --set sweep.N=20,40,60"),
            std::string::npos);
}

TEST_F(RunCommand, DryRunTellsTheGridAndStoresNothing) {
  const ProgramResult result = run({"small.toml", "--dry-run", "--threads", "1"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("cells        4\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("instances    8 (2 a cell, seed 1)\n"), std::string::npos);
  EXPECT_NE(result.out.find("solves       16 timed"), std::string::npos);
  EXPECT_NE(result.out.find("methods      column_generation, zheng_yamane\n"), std::string::npos);
  EXPECT_NE(result.out.find("estimate     about "), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("out")));
}

TEST_F(RunCommand, AnExistingFileIsRefusedAndLeftAlone) {
  ASSERT_EQ(run({"small.toml", "-o", "x.h5"}).status, 0);
  const std::string before = read_bytes(folder_.file("x.h5"));
  EXPECT_EQ(refusal({"small.toml", "-o", "x.h5"}),
            "x.h5: exists already; --resume completes it, --force replaces it");
  EXPECT_EQ(read_bytes(folder_.file("x.h5")), before);
}

TEST_F(RunCommand, ForceReplacesResults) {
  ASSERT_EQ(run({"small.toml", "-o", "x.h5"}).status, 0);
  EXPECT_EQ(run({"small.toml", "-o", "x.h5", "--set", "sweep.seed=2", "--force"}).status, 0);
  for (const Record& record : read_results(folder_.file("x.h5")).records) EXPECT_EQ(record.seed, 2u);
}

TEST_F(RunCommand, ResumingAFinishedRunChangesNothing) {
  ASSERT_EQ(run({"small.toml", "-o", "x.h5"}).status, 0);
  const std::string before = read_bytes(folder_.file("x.h5"));
  const ProgramResult result = run({"small.toml", "-o", "x.h5", "--resume"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("all 4 cells are done already"), std::string::npos) << result.out;
  EXPECT_EQ(read_bytes(folder_.file("x.h5")), before);
}

TEST_F(RunCommand, ResumingAnotherExperimentIsRefused) {
  ASSERT_EQ(run({"small.toml", "-o", "x.h5"}).status, 0);
  const std::string before = read_bytes(folder_.file("x.h5"));
  EXPECT_EQ(refusal({"small.toml", "-o", "x.h5", "--set", "sweep.seed=2", "--resume"}),
            "x.h5: holds another experiment: seed = 1 there, 2 here");
  EXPECT_EQ(read_bytes(folder_.file("x.h5")), before);
}

TEST_F(RunCommand, ResumingATruncatedFileIsRefused) {
  ASSERT_EQ(run({"small.toml", "-o", "x.h5"}).status, 0);
  const std::string half = read_bytes(folder_.file("x.h5")).substr(0, 5000);
  write_bytes(folder_.file("x.h5"), half);
  EXPECT_TRUE(refusal({"small.toml", "-o", "x.h5", "--resume"}).starts_with("x.h5: "));
  EXPECT_EQ(read_bytes(folder_.file("x.h5")), half);
}

TEST_F(RunCommand, AFileThatIsNotOursIsNeverReplaced) {
  write_bytes(folder_.file("thesis.txt"), "years of work");
  for (const char* option : {"--force", "--resume"}) {
    EXPECT_TRUE(refusal({"small.toml", "-o", "thesis.txt", option}).starts_with("thesis.txt: "));
    EXPECT_EQ(read_bytes(folder_.file("thesis.txt")), "years of work");
  }
}

TEST_F(RunCommand, AFolderThatCannotBeWrittenIsNamed) {
  write_bytes(folder_.file("file"), "no folder");
  EXPECT_EQ(refusal({"small.toml", "-o", "file/x.h5"}),
            "file/x.h5.parts: cannot create the folder: Not a directory");
  EXPECT_EQ(read_bytes(folder_.file("file")), "no folder");
}

TEST_F(RunCommand, ADiskThatTakesNoMoreEndsTheRunWithOneLine) {
  // The limit lets the description of the session through, but not a cell of 400 records.
  testing::Program program(folder_.path(),
                           {"run", "small.toml", "-o", "x.h5", "--quiet", "--set", "sweep.repetitions=200"},
                           30000);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, "raygauge: x.h5.parts/cells-0000.csv: cannot write: File too large\n");
  EXPECT_FALSE(std::filesystem::exists(folder_.file("x.h5")));
  EXPECT_EQ(run({"small.toml", "-o", "x.h5", "--set", "sweep.repetitions=200", "--resume"}).status, 0);
  EXPECT_TRUE(read_results(folder_.file("x.h5")).finished());
}

TEST_F(RunCommand, BadExperimentsAreRefusedWithFileAndLine) {
  EXPECT_EQ(refusal({"nowhere.toml"}), "nowhere.toml: No such file or directory");
  const std::string text = kExperiment;
  EXPECT_EQ(refusal_of_text(text + "time_limits = 3\n"),
            "bad.toml:14: unknown [run] key 'time_limits'; did you mean 'time_limit'? "
            "(known: threads timing pin_threads warmup min_seconds time_limit shuffle)");
  EXPECT_EQ(refusal_of_text(text + "time_limit = \"long\"\n"),
            "bad.toml:14: run.time_limit must be a number, got 'long'");
  EXPECT_EQ(refusal_of_text(text + "warmup = -1\n"),
            "bad.toml:14: run.warmup must lie in [0, 2147483647], got -1");
  EXPECT_TRUE(refusal_of_text(text + "[[method]]\nname = \"newtonn\"\n")
                  .starts_with("bad.toml:15: unknown method 'newtonn'; did you mean 'newton'? (known: "));
  EXPECT_TRUE(refusal_of_text("[[generator]]\nname = \"needel\"\n")
                  .starts_with("bad.toml:2: unknown generator 'needel'; did you mean 'needle'? (known: "));
  EXPECT_TRUE(refusal_of_text("[[generator]]\nname = \"example2\"\nseparation = 0.5\n")
                  .starts_with("bad.toml:3: generator 'example2': parameter 'separation' must lie in [1, "));
  EXPECT_TRUE(refusal_of_text(text + "[[[\n").starts_with("bad.toml:14: "));
}

TEST_F(RunCommand, BadOverridesAreRefused) {
  EXPECT_EQ(refusal({"small.toml", "--set", "sweep.m=3"}),
            "--set sweep.m=3: unknown [sweep] key 'm'; did you mean 'n'? "
            "(known: n N tolerance grid repetitions min_repetitions stop_when_within seed)");
  EXPECT_EQ(refusal({"small.toml", "--set", "foo.bar=3"}),
            "--set foo.bar=3: unknown key 'foo' (known: name description sweep generator method run)");
  EXPECT_EQ(refusal({"small.toml", "--set", "swep.n=3"}),
            "--set swep.n=3: unknown key 'swep'; did you mean 'sweep'? "
            "(known: name description sweep generator method run)");
  EXPECT_EQ(refusal({"small.toml", "--set", "sweep.n.x=3"}),
            "--set sweep.n.x=3: 'n' is a value or a list of values, not a table");
  EXPECT_EQ(refusal({"small.toml", "--set", "sweep.n"}),
            "--set sweep.n: expected KEY=VALUE, as in sweep.n=3,4");
  EXPECT_EQ(run({"small.toml", "--threads", "many"}).status, 2);
  EXPECT_EQ(run({"small.toml", "--resume", "--force"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("out")));
}

TEST_F(RunCommand, InterruptedItKeepsTheCellsThatAreDoneAndTellsHowToGoOn) {
  const std::vector<std::string> arguments = {
      "run", "small.toml", "-o", "x.h5", "--set", "sweep.n=3,4,5,6,7,8", "--set", "run.min_seconds=0.02"};
  testing::Program program(folder_.path(), arguments);
  EXPECT_TRUE(appears("x.h5.parts/cells-0000.csv"));
  program.signal(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.status, 130);
  EXPECT_NE(result.err.find(
                "run small.toml -o x.h5 --set sweep.n=3,4,5,6,7,8 --set run.min_seconds=0.02 --resume\n"),
            std::string::npos)
      << result.err;
  const ResultsFile partial = read_results(folder_.file("x.h5"));
  EXPECT_FALSE(partial.finished());
  EXPECT_GE(partial.cells().size(), 1u);

  std::vector<std::string> resumed = arguments;
  resumed.emplace_back("--resume");
  EXPECT_EQ(testing::run_program(folder_.path(), resumed).status, 0);
  EXPECT_TRUE(read_results(folder_.file("x.h5")).finished());
}

TEST_F(RunCommand, InterruptedInALongCellItDoesNotFinishIt) {
  // The first cell alone would take six minutes and more.
  const std::vector<std::string> cell = {"--set", "sweep.repetitions=20000", "--set", "run.min_seconds=0.01"};
  for (const int signal : {SIGINT, SIGTERM}) {
    std::vector<std::string> arguments = {"run", "small.toml", "-o", "x.h5"};
    arguments.insert(arguments.end(), cell.begin(), cell.end());
    testing::Program program(folder_.path(), arguments);
    ASSERT_TRUE(program.comes_to_handle(SIGTERM));
    program.signal(signal);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.status, 128 + signal);
    EXPECT_NE(result.err.find("interrupted: finishing the solves in flight"), std::string::npos);
    EXPECT_NE(result.err.find("interrupted: 0 of 4 cells are done; continue with\n"), std::string::npos)
        << result.err;
    EXPECT_TRUE(result.err.ends_with("--resume\n"));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("x.h5")));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("x.h5.parts")));
  }
}

TEST_F(RunCommand, InterruptedBeforeItReplacesAnythingItDoesNotOfferToResumeTheOldRun) {
  ASSERT_EQ(run({"small.toml", "-o", "x.h5"}).status, 0);
  const std::string before = read_bytes(folder_.file("x.h5"));
  testing::Program program(folder_.path(), {"run", "small.toml", "-o", "x.h5", "--force", "--set",
                                            "sweep.repetitions=20000", "--set", "run.min_seconds=0.01"});
  ASSERT_TRUE(program.comes_to_handle(SIGTERM));
  program.signal(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.status, 130);
  EXPECT_TRUE(result.err.ends_with("--force\n")) << result.err;
  EXPECT_EQ(read_bytes(folder_.file("x.h5")), before);
}

}  // namespace
}  // namespace raygauge::test_command_run
