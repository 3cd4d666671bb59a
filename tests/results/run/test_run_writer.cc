// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/run_writer.h"

#include <H5Cpp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <thread>

#include "results/exceptions.h"
#include "results/run/results_file.h"
#include "tests/results/support.h"

namespace raygauge::test_run_writer {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

class RunWriterTest : public ::testing::Test {
 protected:
  /// Stores `cells` as one session, and finishes it or, like a killed program, does not.
  void write(RunMode mode, const std::vector<std::uint64_t>& cells, bool finish) {
    RunWriter run(path_, experiment_, mode, sample_session());
    for (const std::uint64_t cell : cells) run.store(cell_result(experiment_, cell));
    if (finish) run.finish();
  }
  std::string error_opening(RunMode mode) {
    return error_of([&] { RunWriter(path_, experiment_, mode, sample_session()); });
  }
  std::vector<std::string> expected() const { return fingerprints(sample_results(experiment_).records); }
  std::vector<std::string> found() const { return fingerprints(read_results(path_).records); }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("x.h5");
  Experiment experiment_ = small_experiment();
};

TEST_F(RunWriterTest, AWholeRunIsOneFileOfAllRecordsInOrder) {
  write(RunMode::create, {2, 0, 3, 1}, true);
  EXPECT_EQ(found(), expected());
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(RunWriterTest, AProgramWritesTheFileOfASweepThatHasNoText) {
  experiment_.text.clear();
  experiment_.name = "a \"quoted\" \\ name\nof two lines";
  {
    ResultsWriter run(path_, experiment_);
    for (const std::uint64_t cell : {2, 0}) run.store(cell_result(experiment_, cell));
  }  // as if it had been killed
  EXPECT_NE(error_of([&] { ResultsWriter(path_, experiment_); }), "");
  ResultsWriter run(path_, experiment_, RunMode::resume);
  EXPECT_EQ(run.done(), (std::set<std::uint64_t>{0, 2}));
  EXPECT_NE(error_of([&] { run.store(cell_result(experiment_, 0)); }), "");
  for (const std::uint64_t cell : {1, 3}) run.store(cell_result(experiment_, cell));
  run.finish();
  const ResultsFile results = read_results(path_);
  EXPECT_NE(results.provenance.experiment_text.find(R"(name = "a \"quoted\" \\ name\u000aof two lines")"),
            std::string::npos);
  EXPECT_TRUE(results.finished());
  EXPECT_EQ(results.records.size(), expected().size());
  EXPECT_EQ(results.records.front().host, results.provenance.sessions.front().machine.hostname);
}

TEST_F(RunWriterTest, FoldersOnTheWayAreCreated) {
  path_ = folder_.file("out/today/x.h5");
  write(RunMode::create, {0, 1, 2, 3}, true);
  EXPECT_EQ(found(), expected());
}

TEST_F(RunWriterTest, CellsFromSeveralThreadsAreAllStored) {
  experiment_ = small_experiment(40, 2);
  RunWriter run(path_, experiment_, RunMode::create, sample_session());
  std::vector<std::thread> threads;
  for (std::uint64_t first = 0; first < 4; ++first) {
    threads.emplace_back([&, first] {
      for (std::uint64_t cell = first; cell < 40; cell += 4) run.store(cell_result(experiment_, cell));
    });
  }
  for (std::thread& thread : threads) thread.join();
  run.finish();
  EXPECT_EQ(found(), expected());
}

TEST_F(RunWriterTest, AnInterruptedAndResumedRunHasTheSameRecordsInTheSameOrder) {
  write(RunMode::create, {3}, false);
  write(RunMode::resume, {0, 2}, false);
  {
    RunWriter run(path_, experiment_, RunMode::resume, sample_session());
    EXPECT_EQ(run.done(), (std::set<std::uint64_t>{0, 2, 3}));
    run.store(cell_result(experiment_, 1));
    run.finish();
  }
  EXPECT_EQ(found(), expected());
  const ResultsFile results = read_results(path_);
  EXPECT_EQ(results.provenance.sessions.size(), 3U);
  EXPECT_EQ(results.records.front().session, 1);
  EXPECT_EQ(results.records.back().session, 0);
}

TEST_F(RunWriterTest, AnUnfinishedRunCanBeRead) {
  write(RunMode::create, {2}, false);
  const ResultsFile results = read_results(path_);
  EXPECT_EQ(fingerprints(results.records), fingerprints(read_results(path_).records));
  EXPECT_EQ(results.cells(), std::set<std::uint64_t>{2});
  EXPECT_FALSE(results.finished());
  EXPECT_EQ(results.provenance.experiment_text, experiment_.text);
}

TEST_F(RunWriterTest, ARunCanBeReadAtAnyMomentWhileItGoesOnAndEnds) {
  constexpr int kRuns = 10;
  experiment_ = small_experiment(8, 1);
  for (int i = 0; i < kRuns; ++i) {
    path_ = folder_.file(std::to_string(i) + ".h5");
    RunWriter run(path_, experiment_, RunMode::create, sample_session());
    run.store(cell_result(experiment_, 0));
    std::atomic<bool> ended = false;
    std::thread writer([&] {
      for (std::uint64_t cell = 1; cell < 8; ++cell) run.store(cell_result(experiment_, cell));
      run.finish();
      ended = true;
    });
    std::string error;
    while (error.empty() && !ended) error = error_of([this] { read_results(path_); });
    writer.join();
    EXPECT_EQ(error, "");
    EXPECT_EQ(found(), expected());
  }
}

TEST_F(RunWriterTest, ARunThatWasStoppedAndMergedIsResumed) {
  write(RunMode::create, {1, 2}, true);
  EXPECT_FALSE(read_results(path_).finished());
  write(RunMode::resume, {0}, false);
  EXPECT_EQ(read_results(path_).cells(), (std::set<std::uint64_t>{0, 1, 2}));
  write(RunMode::resume, {3}, true);
  EXPECT_EQ(found(), expected());
}

TEST_F(RunWriterTest, ResumingAFinishedRunChangesNothing) {
  write(RunMode::create, {0, 1, 2, 3}, true);
  const std::string before = read_bytes(path_);
  write(RunMode::resume, {}, true);
  EXPECT_EQ(read_bytes(path_), before);
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(RunWriterTest, ResumingNothingStartsARun) {
  write(RunMode::resume, {0, 1, 2, 3}, true);
  EXPECT_EQ(found(), expected());
}

TEST_F(RunWriterTest, ARunKilledBeforeItsMergeIsMergedOnResume) {
  write(RunMode::create, {0, 1, 2, 3}, false);
  write(RunMode::resume, {}, true);
  EXPECT_EQ(found(), expected());
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(RunWriterTest, PartsThatAKillLeftBehindTheMergedFileAreCleanedUp) {
  write(RunMode::create, {0, 1, 2, 3}, false);
  const std::filesystem::path saved = folder_.file("saved");
  std::filesystem::copy(path_ + ".parts", saved);
  write(RunMode::resume, {}, true);
  std::filesystem::rename(saved, path_ + ".parts");
  EXPECT_EQ(found(), expected());
  write(RunMode::resume, {}, true);
  EXPECT_EQ(found(), expected());
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(RunWriterTest, TemporaryFilesOfAKillAreIgnoredAndRemoved) {
  write(RunMode::create, {0, 1}, false);
  write_bytes(path_ + ".parts/cells-0001.csv.tmp", "half a fi");
  EXPECT_EQ(read_results(path_).cells(), (std::set<std::uint64_t>{0, 1}));
  write(RunMode::resume, {2, 3}, true);
  EXPECT_EQ(found(), expected());
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(RunWriterTest, CreateRefusesAnExistingFileAndExistingParts) {
  write(RunMode::create, {0, 1}, false);
  EXPECT_EQ(error_opening(RunMode::create),
            path_ + ".parts: holds 2 cells of an unfinished run; --resume continues it, --force discards it");
  write(RunMode::resume, {2, 3}, true);
  const std::string before = read_bytes(path_);
  EXPECT_EQ(error_opening(RunMode::create),
            path_ + ": exists already; --resume completes it, --force replaces it");
  EXPECT_EQ(read_bytes(path_), before);
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(RunWriterTest, ForceReplacesFileAndParts) {
  write(RunMode::create, {0, 1}, true);
  write(RunMode::resume, {2}, false);
  experiment_ = small_experiment(4, 1);
  write(RunMode::force, {3, 2, 1, 0}, true);
  EXPECT_EQ(found(), expected());
}

TEST_F(RunWriterTest, ForceTouchesNothingBeforeTheFirstCellIsStored) {
  write(RunMode::create, {0, 1}, true);
  write(RunMode::resume, {2}, false);
  const std::vector<std::string> before = found();
  write(RunMode::force, {}, true);
  EXPECT_EQ(found(), before);
}

TEST_F(RunWriterTest, ForceDoesNotReplaceAForeignFile) {
  write_bytes(path_, "a thesis");
  EXPECT_EQ(error_opening(RunMode::force), path_ + ": not an HDF5 file; not replaced even by --force");
  EXPECT_EQ(read_bytes(path_), "a thesis");
}

TEST_F(RunWriterTest, ForceDoesNotReplaceForeignData) {
  { H5::H5File(path_, H5F_ACC_TRUNC).createGroup("measured_for_years"); }
  const std::string before = read_bytes(path_);
  EXPECT_EQ(error_opening(RunMode::force),
            path_ + ": an HDF5 file, but not one of raygauge's results; not replaced even by --force");
  EXPECT_TRUE(read_bytes(path_) == before);
}

TEST_F(RunWriterTest, ALinkIsWrittenThrough) {
  const std::string link = folder_.file("link.h5");
  std::filesystem::create_symlink(path_, link);
  {
    RunWriter run(link, experiment_, RunMode::create, sample_session());
    run.store(cell_result(experiment_, 0));
    EXPECT_TRUE(std::filesystem::exists(path_ + ".parts")) << "the parts lie beside the file, not the link";
    EXPECT_EQ(read_results(link).cells(), std::set<std::uint64_t>{0});
    run.finish();
  }
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(read_results(path_).cells(), std::set<std::uint64_t>{0});
}

TEST_F(RunWriterTest, AnotherExperimentIsNotResumed) {
  write(RunMode::create, {0}, false);
  experiment_.seed = 2;
  EXPECT_EQ(error_opening(RunMode::resume),
            path_ + ": holds another experiment: seed = 18446744073709551615 there, 2 here");
}

TEST_F(RunWriterTest, ThreadsAndOrderMayChangeOnResume) {
  write(RunMode::create, {0, 1}, false);
  experiment_.threads = 7;
  experiment_.shuffle = !experiment_.shuffle;
  experiment_.text += "# a remark\n";
  write(RunMode::resume, {2, 3}, true);
  EXPECT_EQ(found(), expected());
}

TEST_F(RunWriterTest, ACellThatAKillCutShortIsDoneAgain) {
  write(RunMode::create, {0, 1}, false);
  const std::string journal = path_ + ".parts/cells-0000.csv";
  write_bytes(journal, read_bytes(journal).substr(0, read_bytes(journal).size() - 1));
  EXPECT_EQ(read_results(path_).cells(), std::set<std::uint64_t>{0});
  write(RunMode::resume, {1}, false);
  EXPECT_EQ(read_results(path_).cells(), (std::set<std::uint64_t>{0, 1}));
  write(RunMode::resume, {2, 3}, true);
  EXPECT_EQ(found(), expected());
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(RunWriterTest, ADamagedSessionIsNamed) {
  write(RunMode::create, {0, 1}, false);
  const std::string part = path_ + ".parts/session-0000.h5";
  write_bytes(part, read_bytes(part).substr(0, 3000));
  EXPECT_EQ(error_opening(RunMode::resume).substr(0, part.size() + 22), part + ": truncated or damaged");
}

TEST_F(RunWriterTest, CellsWithoutTheirSessionAreNotTakenForAnotherOnes) {
  write(RunMode::create, {0}, false);
  write(RunMode::resume, {1}, false);
  std::filesystem::remove(path_ + ".parts/session-0001.h5");
  const std::string journal = path_ + ".parts/cells-0001.csv";
  EXPECT_EQ(error_opening(RunMode::resume), journal + ": the session of these cells is missing");
  std::filesystem::remove(journal);
  write(RunMode::resume, {1, 2, 3}, true);
  EXPECT_EQ(found(), expected());
}

TEST_F(RunWriterTest, CreateRefusesPartsThatItCannotCount) {
  write(RunMode::create, {0, 1}, false);
  write_bytes(path_ + ".parts/cells-0000.csv", "");
  EXPECT_EQ(error_opening(RunMode::create),
            path_ + ".parts: holds cells of an unfinished run; --resume continues it, --force discards it");
}

TEST_F(RunWriterTest, ACellIsStoredOnlyOnce) {
  write(RunMode::create, {0}, false);
  RunWriter run(path_, experiment_, RunMode::resume, sample_session());
  run.store(cell_result(experiment_, 1));
  EXPECT_THROW(run.store(cell_result(experiment_, 0)), InvalidParameterError);
  EXPECT_THROW(run.store(cell_result(experiment_, 1)), InvalidParameterError);
}

TEST_F(RunWriterTest, ACellThatIsNotOfTheExperimentIsRefused) {
  RunWriter run(path_, experiment_, RunMode::create, sample_session());
  EXPECT_THROW(run.store({0, {}}), InvalidParameterError);
  CellResult cell = cell_result(experiment_, 0);
  cell.cell = 1;
  EXPECT_THROW(run.store(cell), InvalidParameterError);
  cell = cell_result(experiment_, 0);
  cell.records.back().method = "unheard of";
  EXPECT_THROW(run.store(cell), InvalidParameterError);
}

TEST_F(RunWriterTest, TwoWritersOfOneRunAreRefused) {
  const RunWriter run(path_, experiment_, RunMode::create, sample_session());
  EXPECT_THROW(RunWriter(path_, experiment_, RunMode::resume, sample_session()), RunLockedError);
  EXPECT_EQ(error_opening(RunMode::force),
            path_ + ".parts: another process is writing this run (process " + std::to_string(getpid()) + ")");
}

}  // namespace
}  // namespace raygauge::test_run_writer
