// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/disk/atomic_file.h"

#include <gtest/gtest.h>

#include "results/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::test_atomic_file {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

TEST(AtomicFile, HoldsTheBytesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n", 4);
  write_atomically(folder.file("x"), bytes);
  EXPECT_EQ(read_bytes(folder.file("x")), bytes);
  write_atomically(folder.file("x"), "");
  EXPECT_EQ(read_bytes(folder.file("x")), "");
  EXPECT_EQ(entries_of(folder.path()), std::vector<std::string>{"x"});
}

TEST(AtomicFile, StaysAsItWasWhereTheNewOneCannotBeWritten) {
  const TemporaryFolder folder;
  write_bytes(folder.file("x"), "old");
  std::filesystem::create_symlink("/dev/full", folder.file("x.tmp"));
  EXPECT_EQ(error_of([&] { write_atomically(folder.file("x"), "new", folder.file("x.tmp")); }),
            folder.file("x") + ": cannot write: No space left on device");
  EXPECT_EQ(read_bytes(folder.file("x")), "old");
  EXPECT_EQ(entries_of(folder.path()), std::vector<std::string>{"x"});
}

TEST(AtomicFile, StaysAsItWasWhereItsSourceFails) {
  const TemporaryFolder folder;
  write_bytes(folder.file("x"), "old");
  const ByteSource fails = [](const ByteSink& put) {
    put("half of");
    throw ResultsError("no more");
  };
  EXPECT_EQ(error_of([&] { write_atomically(folder.file("x"), fails); }), "no more");
  EXPECT_EQ(read_bytes(folder.file("x")), "old");
  EXPECT_EQ(entries_of(folder.path()), std::vector<std::string>{"x"});
}

TEST(AtomicFile, AFolderIsNotReplaced) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("x"));
  EXPECT_EQ(error_of([&] { write_atomically(folder.file("x"), "new"); }),
            folder.file("x") + ": cannot write: Is a directory");
  EXPECT_EQ(entries_of(folder.path()), std::vector<std::string>{"x"});
}

TEST(AppendedFile, GrowsByBlocks) {
  const TemporaryFolder folder;
  write_bytes(folder.file("x"), "a");
  AppendedFile file(folder.file("x"));
  file.append("b");
  file.append("cd");
  EXPECT_EQ(read_bytes(folder.file("x")), "abcd");
}

TEST(AppendedFile, TheSystemsReasonIsNamed) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of([&] { AppendedFile(folder.file("x")); }),
            folder.file("x") + ": cannot open: No such file or directory");
  std::filesystem::create_symlink("/dev/full", folder.file("full"));
  AppendedFile full(folder.file("full"));
  EXPECT_EQ(error_of([&] { full.append("a"); }),
            folder.file("full") + ": cannot write: No space left on device");
}

}  // namespace
}  // namespace raygauge::test_atomic_file
