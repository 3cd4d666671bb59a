// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/disk/run_directory.h"

#include <gtest/gtest.h>

#include "results/exceptions.h"
#include "tests/results/support.h"

namespace raygauge::test_run_directory {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

class RunDirectoryTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  std::string target_ = folder_.file("x.h5");
  std::string parts_ = target_ + ".parts";
};

TEST_F(RunDirectoryTest, PartsAreFoundByNumberHoweverLarge) {
  const RunDirectory directory(target_);
  write_bytes(directory.journal_path(0), "a");
  write_bytes(directory.journal_path(12345678901), "b");
  directory.store_session(3, "c");
  const PartList parts = list_parts(target_);
  EXPECT_EQ(parts.journals.at(0), directory.journal_path(0));
  EXPECT_EQ(parts.journals.at(12345678901), directory.journal_path(12345678901));
  EXPECT_EQ(read_bytes(parts.sessions.at(3)), "c");
  EXPECT_EQ(entries_of(parts_),
            (std::vector<std::string>{"cells-0000.csv", "cells-12345678901.csv", "lock", "session-0003.h5"}));
}

TEST_F(RunDirectoryTest, WhatIsNoPartIsLeftAlone) {
  {
    const RunDirectory directory(target_);
    for (const char* name :
         {"cells-1.csv", "cells-000x.csv", "cells-0001.csv.bak", "notes.txt", "session-.h5"}) {
      write_bytes(parts_ + "/" + name, "mine");
    }
    EXPECT_TRUE(directory.parts().empty());
    directory.clear();
  }
  EXPECT_EQ(entries_of(parts_).size(), 5U);
}

TEST_F(RunDirectoryTest, AnEmptyOneIsRemovedAtTheEnd) {
  { const RunDirectory directory(target_); }
  EXPECT_EQ(entries_of(folder_.path()), std::vector<std::string>{});
}

TEST_F(RunDirectoryTest, OneWithPartsStaysWithoutItsLock) {
  {
    const RunDirectory directory(target_);
    directory.store_session(1, "a");
  }
  EXPECT_EQ(entries_of(parts_), std::vector<std::string>{"session-0001.h5"});
}

TEST_F(RunDirectoryTest, NoFolderMeansNoParts) { EXPECT_TRUE(list_parts(target_).empty()); }

}  // namespace
}  // namespace raygauge::test_run_directory
