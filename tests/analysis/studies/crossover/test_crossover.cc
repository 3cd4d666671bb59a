// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/crossover/crossover.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis/records.h"

namespace raygauge::test_crossover {
namespace {

using raygauge::testing::add_records;

TEST(Crossover, NamesTheWinnerOfEachCellAndItsLead) {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2, 3, 4, 5, 6, 7, 8});
  add_records(records, "glpk_dual", 3, 200, {3, 6, 9, 12, 15, 18, 21, 24});
  add_records(records, "column_generation", 9, 200, {5, 5, 5, 5, 5, 5, 5, 5});
  add_records(records, "glpk_dual", 9, 200, {4, 6, 4.4, 6, 4, 6, 4, 4.9});
  const std::vector<CellWinner> winners = cell_winners(records);
  ASSERT_EQ(winners.size(), 2U);
  EXPECT_EQ(winners[0].method, "column_generation");
  EXPECT_EQ(winners[0].runner_up, "glpk_dual");
  EXPECT_NEAR(winners[0].lead.ratio, 3, 1e-12);
  EXPECT_TRUE(winners[0].decided);
  EXPECT_EQ(winners[1].method, "glpk_dual");
  EXPECT_FALSE(winners[1].decided);
}

TEST(Crossover, ComparesMediansWhereTheTwoShareNoInstance) {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2, 3});
  add_records(records, "glpk_dual", 3, 200, {2, 4, 6});
  for (std::size_t i = 3; i < 6; ++i) records[i].seed = 2;
  EXPECT_DOUBLE_EQ(cell_winners(records).at(0).lead.ratio, 2);
}

TEST(Crossover, TheWinnerLeadsOnTheInstancesThatBothSolved) {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2, 9, 9, 9});  // median 9, faster on three of five
  add_records(records, "glpk_dual", 3, 200, {8, 8, 8, 10, 11});        // median 8
  const CellWinner winner = cell_winners(records).at(0);
  EXPECT_EQ(winner.method, "column_generation");
  EXPECT_EQ(winner.runner_up, "glpk_dual");
  EXPECT_GE(winner.lead.ratio, 1);
  EXPECT_DOUBLE_EQ(winner.seconds, 9e-3);
}

TEST(Crossover, CountsDisagreementAsNeverSolved) {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2, 3});
  add_records(records, "glpk_dual", 3, 200, {2, 4, 6});
  records[0].agrees = records[1].agrees = false;
  EXPECT_EQ(cell_winners(records).at(0).method, "glpk_dual");
}

TEST(Crossover, LeavesOutCellsThatNobodySolves) {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2});
  add_records(records, "glpk_dual", 3, 200, {1, 2});
  for (Record& record : records) record.status = DistanceStatus::time_limit;
  EXPECT_TRUE(cell_winners(records).empty());
  records[2].status = records[3].status = DistanceStatus::optimal;
  const std::vector<CellWinner> winners = cell_winners(records);
  ASSERT_EQ(winners.size(), 1U);
  EXPECT_EQ(winners[0].runner_up, "");
  EXPECT_TRUE(std::isnan(winners[0].lead.ratio));
}

}  // namespace
}  // namespace raygauge::test_crossover
