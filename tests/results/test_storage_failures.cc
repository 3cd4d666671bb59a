// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What a run says, and keeps, where the system does not let it write.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "results/disk/atomic_file.h"
#include "results/exceptions.h"
#include "results/journal/csv.h"
#include "results/run/results_file.h"
#include "results/run/run_writer.h"
#include "tests/results/support.h"

namespace raygauge::test_storage_failures {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

constexpr uid_t kNobody = 65534;

class StorageFailure : public ::testing::Test {
 protected:
  /// From now on the file `name` of the run directory is on a disk that is full.
  void fill_disk_under(const std::string& name) const {
    std::filesystem::create_symlink("/dev/full", path_ + ".parts/" + name + ".tmp");
  }
  std::string error_opening(const std::string& path) const {
    return error_of([&] { RunWriter(path, experiment_, RunMode::create, sample_session()); });
  }

  /// Ends the process, as the next one does; the message goes to standard error.
  [[noreturn]] void store_two_cells_the_second_too_large() const {
    RunWriter run(path_, experiment_, RunMode::create, sample_session());
    run.store(cell_result(experiment_, 0));
    std::signal(SIGXFSZ, SIG_IGN);
    const rlim_t size = std::filesystem::file_size(path_ + ".parts/cells-0000.csv");
    const rlimit limit = {size + 500, size + 500};  // half a cell
    setrlimit(RLIMIT_FSIZE, &limit);
    std::fputs(error_of([&] { run.store(cell_result(experiment_, 1)); }).c_str(), stderr);
    std::_Exit(std::filesystem::file_size(path_ + ".parts/cells-0000.csv") == size ? 0 : 1);
  }
  [[noreturn]] void open_without_privileges() const {
    if (getuid() == 0 && setuid(kNobody) != 0) std::_Exit(1);
    std::fputs(error_opening(path_).c_str(), stderr);
    std::_Exit(0);
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("x.h5");
  Experiment experiment_ = small_experiment();
};

TEST_F(StorageFailure, AFullDiskStopsACellAndKeepsTheOthers) {
  RunWriter(path_, experiment_, RunMode::create, sample_session()).store(cell_result(experiment_, 0));
  {
    RunWriter run(path_, experiment_, RunMode::resume, sample_session());
    fill_disk_under("cells-0001.csv");
    EXPECT_EQ(error_of([&] { run.store(cell_result(experiment_, 1)); }),
              path_ + ".parts/cells-0001.csv: cannot write: No space left on device");
  }
  EXPECT_EQ(read_results(path_).cells(), std::set<std::uint64_t>{0});
  EXPECT_EQ(entries_of(path_ + ".parts"),
            (std::vector<std::string>{"cells-0000.csv", "session-0000.h5", "session-0001.h5"}));
}

TEST_F(StorageFailure, AFullDiskStopsTheMergeAndKeepsTheParts) {
  {
    RunWriter run(path_, experiment_, RunMode::create, sample_session());
    for (std::uint64_t cell = 0; cell < 4; ++cell) run.store(cell_result(experiment_, cell));
    fill_disk_under("merged");
    EXPECT_EQ(error_of([&] { run.finish(); }), path_ + ": cannot write: No space left on device");
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_TRUE(read_results(path_).finished());
  EXPECT_NE(read_results(path_).provenance.sessions.front().finished_at, sample_session().finished_at);
  RunWriter(path_, experiment_, RunMode::resume, sample_session()).finish();
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.h5"});
}

TEST_F(StorageFailure, AFullDiskStopsAnExportAndKeepsTheOldOne) {
  write_bytes(folder_.file("x.csv"), "old");
  std::filesystem::create_symlink("/dev/full", folder_.file("x.csv." + std::to_string(getpid()) + ".tmp"));
  EXPECT_EQ(error_of([&] {
              write_atomically(folder_.file("x.csv"), csv_text(sample_results(experiment_).records));
            }),
            folder_.file("x.csv") + ": cannot write: No space left on device");
  EXPECT_EQ(read_bytes(folder_.file("x.csv")), "old");
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{"x.csv"});
}

TEST_F(StorageFailure, AWriteThatFailsHalfWayLeavesNoHalfCell) {
  EXPECT_EXIT(store_two_cells_the_second_too_large(), ::testing::ExitedWithCode(0),
              "cells-0000.csv: cannot write: File too large");
  EXPECT_EQ(read_results(path_).cells(), std::set<std::uint64_t>{0});
  EXPECT_EQ(entries_of(path_ + ".parts"),
            (std::vector<std::string>{"cells-0000.csv", "lock", "session-0000.h5"}));
}

TEST_F(StorageFailure, AFileWhereAFolderShouldBeIsNamed) {
  write_bytes(folder_.file("file"), "no folder");
  EXPECT_EQ(error_opening(folder_.file("file/x.h5")),
            folder_.file("file/x.h5.parts") + ": cannot create the folder: Not a directory");
}

TEST_F(StorageFailure, AFolderWithoutPermissionIsNamed) {
  ASSERT_EQ(chmod(folder_.path().c_str(), 0555), 0);
  EXPECT_EXIT(open_without_privileges(), ::testing::ExitedWithCode(0),
              "x.h5.parts: cannot create the folder: Permission denied");
}

}  // namespace
}  // namespace raygauge::test_storage_failures
