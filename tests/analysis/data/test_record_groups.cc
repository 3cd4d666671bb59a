// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/record_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/analysis/records.h"

namespace raygauge::test_record_groups {
namespace {

using testing::record;

/// Two methods in turn on three instances, in two cells.
std::vector<Record> records_in_turn() {
  std::vector<Record> records;
  for (const int N : {200, 400}) {
    for (const int repetition : {0, 1, 2}) {
      records.push_back(record("newton", 3, N, repetition, 1));
      records.push_back(record("glpk_dual", 3, N, repetition, 2));
    }
  }
  return records;
}

std::vector<std::string> words(const RecordGroups& groups) {
  std::vector<std::string> result;
  for (const RecordGroup& group : groups)
    result.push_back(group.first().method + " " + std::to_string(group.cell.N) + ": " +
                     std::to_string(group.records.size()));
  return result;
}

TEST(RecordGroups, AreCellsAndMethodsInOrderOfFirstAppearance) {
  const std::vector<Record> records = records_in_turn();
  const RecordGroups groups(records);
  const std::vector<std::string> expected = {"newton 200: 3", "glpk_dual 200: 3", "newton 400: 3",
                                             "glpk_dual 400: 3"};
  EXPECT_EQ(words(groups), expected);
  EXPECT_EQ(groups.methods().labels(), (std::vector<std::string>{"newton", "glpk_dual"}));
  EXPECT_EQ(groups.begin()->records[1], &records[2]) << "in the order of the records";
}

TEST(RecordGroups, AreTheSameInWhateverOrderTheRecordsAre) {
  std::vector<Record> records = records_in_turn();
  std::ranges::stable_sort(records, {}, &Record::repetition);
  std::vector<std::string> sorted = words(RecordGroups(records));
  std::ranges::sort(sorted);
  EXPECT_EQ(sorted, (std::vector<std::string>{"glpk_dual 200: 3", "glpk_dual 400: 3", "newton 200: 3",
                                              "newton 400: 3"}));
}

TEST(RecordGroups, TellParametersAndTolerancesApart) {
  std::vector<Record> records = {record("newton", 3, 200, 0, 1), record("newton", 3, 200, 0, 1),
                                 record("newton", 3, 200, 0, 1), record("newton", 3, 200, 0, 1)};
  records[1].method_parameters = "extended=true";
  records[2].generator_parameters = "separation=3";
  records[3].tolerance = 1e-9;
  EXPECT_EQ(words(RecordGroups(records)).size(), 4U);
  EXPECT_TRUE(RecordGroups(std::vector<Record>()).empty());
}

}  // namespace
}  // namespace raygauge::test_record_groups
