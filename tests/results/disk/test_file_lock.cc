// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/disk/file_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <optional>

#include "results/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::test_file_lock {
namespace {

class FileLockTest : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
  std::string path_ = folder_.file("lock");
};

TEST_F(FileLockTest, IsHeldByOneAtATime) {
  std::optional<FileLock> lock(path_);
  EXPECT_THROW(FileLock{path_}, RunLockedError);
  lock.reset();
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_NO_THROW(FileLock{path_});
}

TEST_F(FileLockTest, TheMessageNamesTheProcess) {
  const FileLock lock(path_);
  EXPECT_EQ(
      testing::error_of([this] { FileLock{path_}; }),
      folder_.path() + ": another process is writing this run (process " + std::to_string(getpid()) + ")");
}

TEST_F(FileLockTest, AKilledHolderHoldsNoLonger) {
  std::array<int, 2> locked{};
  ASSERT_EQ(pipe(locked.data()), 0);
  const pid_t child = fork();
  if (child == 0) {
    const FileLock lock(path_);
    const bool told = write(locked[1], "!", 1) == 1;
    if (told) pause();
    _exit(1);
  }
  char told = 0;
  ASSERT_EQ(read(locked[0], &told, 1), 1);
  EXPECT_THROW(FileLock{path_}, RunLockedError);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(path_));
  EXPECT_NO_THROW(FileLock{path_});
}

TEST_F(FileLockTest, AMissingFolderIsNamed) {
  const std::string path = folder_.file("missing/lock");
  EXPECT_EQ(testing::error_of([&] { FileLock{path}; }), path + ": cannot create: No such file or directory");
}

}  // namespace
}  // namespace raygauge::test_file_lock
