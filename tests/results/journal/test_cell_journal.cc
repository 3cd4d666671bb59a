// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/journal/cell_journal.h"

#include <gtest/gtest.h>

#include <thread>

#include "results/exceptions.h"
#include "results/run/results_file.h"
#include "tests/results/support.h"

namespace raygauge::test_cell_journal {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): the helpers of this room's tests

class CellJournalTest : public ::testing::Test {
 protected:
  std::vector<Record> records_of(std::uint64_t cell) const {
    std::vector<Record> records = sample_results(experiment_).records;
    std::erase_if(records, [cell](const Record& record) { return record.cell != cell; });
    return records;
  }

  /// Writes a journal of these cells; the length of the file after its head and after each cell.
  std::vector<std::size_t> write(const std::vector<std::uint64_t>& cells) const {
    CellJournal journal(path_);
    std::vector<std::size_t> lengths = {read_bytes(path_).size()};
    for (const std::uint64_t cell : cells) {
      journal.append(cell, records_of(cell));
      lengths.push_back(read_bytes(path_).size());
    }
    return lengths;
  }

  std::set<std::uint64_t> found() const { return ResultsFile{read_cell_journal(path_), {}}.cells(); }
  std::string error() const {
    return error_of([this] { read_cell_journal(path_); });
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.file("cells.csv");
  Experiment experiment_ = small_experiment(3, 2);
};

TEST_F(CellJournalTest, CellsAreReadInTheOrderInWhichTheyWereAppended) {
  write({2, 0});
  std::vector<std::string> expected = fingerprints(records_of(2));
  const std::vector<std::string> second = fingerprints(records_of(0));
  expected.insert(expected.end(), second.begin(), second.end());
  EXPECT_EQ(fingerprints(read_cell_journal(path_)), expected);
}

TEST_F(CellJournalTest, OneWithoutCellsIsEmpty) {
  write({});
  EXPECT_TRUE(read_cell_journal(path_).empty());
}

TEST_F(CellJournalTest, ATextThatLooksLikeACellIsNone) {
  std::vector<Record> records = records_of(1);
  records.front().method = "a\n# cell 0: 0 bytes, CRC-32 00000000\nb";
  {
    CellJournal journal(path_);
    journal.append(1, records);
    journal.append(2, records_of(2));
  }
  EXPECT_EQ(found(), (std::set<std::uint64_t>{1, 2}));
  EXPECT_EQ(read_cell_journal(path_).front().method, records.front().method);
}

TEST_F(CellJournalTest, CutShortAnywhereItHoldsTheCellsBefore) {
  const std::vector<std::size_t> lengths = write({0, 1, 2});
  const std::string bytes = read_bytes(path_);
  for (std::size_t length = lengths.front(); length <= bytes.size(); length += 7) {
    write_bytes(path_, bytes.substr(0, length));
    std::set<std::uint64_t> whole;
    for (std::uint64_t cell = 0; cell < 3; ++cell) {
      if (lengths[cell + 1] <= length) whole.insert(cell);
    }
    ASSERT_EQ(found(), whole) << length;
  }
}

TEST_F(CellJournalTest, ACellIsLeftOutWhereverABitOfItFlips) {
  const std::vector<std::size_t> lengths = write({0, 1, 2});
  const std::string bytes = read_bytes(path_);
  for (std::size_t i = lengths[1]; i < lengths[2]; ++i) {
    std::string damaged = bytes;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    write_bytes(path_, damaged);
    ASSERT_EQ(found(), (std::set<std::uint64_t>{0, 2})) << i;
  }
}

TEST_F(CellJournalTest, CellsAfterOneThatIsTornOrEmptyAreRead) {
  const std::vector<std::size_t> lengths = write({0, 1, 2});
  const std::string bytes = read_bytes(path_);
  const std::string before = bytes.substr(0, lengths[1]), after = bytes.substr(lengths[2]);
  const std::string torn = bytes.substr(lengths[1], (lengths[2] - lengths[1]) / 2);
  for (const std::string& middle : {torn, std::string(lengths[2] - lengths[1], '\0'), std::string("#"),
                                    std::string("# cell 2: 0 bytes, CRC-32 00000000\n")}) {
    write_bytes(path_, before + middle + after);
    EXPECT_EQ(found(), (std::set<std::uint64_t>{0, 2})) << middle;
  }
}

TEST_F(CellJournalTest, ZerosThatAPowerFailureLeftAreNoCell) {
  write({0, 1});
  write_bytes(path_, read_bytes(path_) + std::string(5000, '\0'));
  EXPECT_EQ(found(), (std::set<std::uint64_t>{0, 1}));
}

TEST_F(CellJournalTest, ACellThatWasStoredAgainIsReadOnce) {
  write({0, 0});
  EXPECT_EQ(fingerprints(read_cell_journal(path_)), fingerprints(records_of(0)));
}

TEST_F(CellJournalTest, ThreadsDoNotMixTheirCells) {
  experiment_ = small_experiment(24, 2);
  {
    CellJournal journal(path_);
    std::vector<std::thread> threads;
    for (std::uint64_t first = 0; first < 3; ++first) {
      threads.emplace_back([&, first] {
        for (std::uint64_t cell = first; cell < 24; cell += 3) journal.append(cell, records_of(cell));
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  EXPECT_EQ(found().size(), 24U);
}

TEST_F(CellJournalTest, WhatIsNoJournalIsRefused) {
  EXPECT_EQ(error(), path_ + ": cannot open: No such file or directory");
  for (const char* bytes : {"", "# cell 0: 0 bytes, CRC-32 00000000\n", "cell,session\n"}) {
    write_bytes(path_, bytes);
    EXPECT_EQ(error(), path_ + ": not a journal of raygauge's cells");
  }
  write_bytes(path_, "# raygauge-results, schema version 3\ncell,session\n");
  EXPECT_EQ(error(), path_ + ": has other columns than a journal of cells: column generator is missing");
}

TEST_F(CellJournalTest, AnotherSchemaVersionIsRefused) {
  write_bytes(path_, "# raygauge-results, schema version 4\n");
  EXPECT_THROW(read_cell_journal(path_), SchemaVersionError);
  EXPECT_EQ(error(), path_ + ": schema version 4, this raygauge reads version 3");
  write_bytes(path_, "# raygauge-results, schema version 18446744073709551615\n");
  EXPECT_EQ(error(), path_ + ": schema version 9223372036854775807, this raygauge reads version 3");
  write_bytes(path_, "# raygauge-results, schema version 2\ncell,session\n");
  EXPECT_THROW(read_cell_journal(path_), SchemaVersionError);
  EXPECT_EQ(error(),
            path_ + ": schema version 2, from before the first release (0.2), is not read: measure anew");
}

TEST_F(CellJournalTest, ACellOfAnotherNumberThanItsRecordsIsRefused) {
  CellJournal(path_).append(1, records_of(0));
  EXPECT_EQ(error(), path_ + ": cell 1 holds records of another cell");
}

}  // namespace
}  // namespace raygauge::test_cell_journal
