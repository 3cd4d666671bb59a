// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/cell_ratio.h"

#include <gtest/gtest.h>

#include <cmath>

#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_cell_ratio {
namespace {

using testing::add_records;
using testing::message_of;
using testing::record;

const std::vector<std::string> kGlpk = {"glpk_primal", "glpk_dual"};

std::vector<Record> two_cells() {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2, 3});
  add_records(records, "glpk_primal", 3, 200, {20, 30, 40});
  add_records(records, "glpk_dual", 3, 200, {10, 20, 90});
  add_records(records, "column_generation", 3, 400, {5, 5, 5});
  add_records(records, "glpk_primal", 3, 400, {50, 50, 50});
  add_records(records, "glpk_dual", 3, 400, {60, 60, 60});
  return records;
}

TEST(CellRatio, DividesMediansByThoseOfTheBetterBaselineOfEachCell) {
  const std::vector<Record> records = two_cells();
  const std::vector<CellRatio> ratios = cell_ratios(records, records, kGlpk);
  ASSERT_EQ(ratios.size(), 2U);
  EXPECT_EQ(ratios[0].times.cell.N, 200);
  EXPECT_EQ(ratios[0].baseline, "glpk_dual");
  EXPECT_DOUBLE_EQ(ratios[0].ratio.ratio, 2.0 / 20);
  EXPECT_EQ(ratios[1].baseline, "glpk_primal");
  EXPECT_DOUBLE_EQ(ratios[1].ratio.ratio, 5.0 / 50);
  EXPECT_DOUBLE_EQ(ratios[1].median_seconds, 0.005);
  EXPECT_DOUBLE_EQ(ratios[1].baseline_seconds, 0.05);
}

TEST(CellRatio, LeavesOutTimesThatDisagreeAndCountsThem) {
  std::vector<Record> records = two_cells();
  records[2].agrees = false;  // column_generation, N=200, 3 ms
  const CellRatio ratio = cell_ratios(records, records, kGlpk).front();
  EXPECT_EQ(ratio.times.disagreeing, 1U);
  EXPECT_DOUBLE_EQ(ratio.ratio.ratio, 1.5 / 20);
}

TEST(CellRatio, CountsUnsolvedAsInfinitelySlow) {
  std::vector<Record> records = two_cells();
  records[0].status = DistanceStatus::time_limit;  // column_generation, N=200, 1 ms
  CellRatio ratio = cell_ratios(records, records, kGlpk).front();
  EXPECT_EQ(ratio.times.unsolved, 1U);
  EXPECT_DOUBLE_EQ(ratio.ratio.ratio, 3.0 / 20);
  records[1].status = DistanceStatus::iteration_limit;
  ratio = cell_ratios(records, records, kGlpk).front();
  EXPECT_TRUE(std::isinf(ratio.ratio.ratio));
}

TEST(CellRatio, HasNoneWhereNoBaselineIsSolved) {
  std::vector<Record> records = two_cells();
  for (Record& each : records)
    if (each.N == 200 && each.method != "column_generation") each.status = DistanceStatus::time_limit;
  const std::vector<CellRatio> ratios = cell_ratios(records, records, kGlpk);
  EXPECT_TRUE(std::isnan(ratios[0].ratio.ratio));
  EXPECT_EQ(ratios[0].baseline, "");
  EXPECT_DOUBLE_EQ(ratios[1].ratio.ratio, 0.1);
}

TEST(CellRatio, KeepsDifferentParametersOfAMethodApart) {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2});
  records[1].method_parameters = "instruction_set=avx2";
  EXPECT_EQ(cell_times(records).size(), 2U);
}

TEST(BaselineRecords, AreThoseThatPassTheFilter) {
  const std::vector<Record> records = two_cells();
  const auto kept = baseline_records(records, Filter("N==200 && method!=glpk_dual"), kGlpk);
  ASSERT_EQ(kept.size(), 3U);
  for (const Record& each : kept) EXPECT_EQ(each.method, "glpk_primal");
}

TEST(BaselineRecords, AreThoseOnTheSameInstancesWhereNonePasses) {
  const std::vector<Record> records = two_cells();
  const auto kept =
      baseline_records(records, Filter("method==column_generation && N==400 && repetition<2"), kGlpk);
  ASSERT_EQ(kept.size(), 4U);
  for (const Record& each : kept) {
    EXPECT_EQ(each.N, 400);
    EXPECT_LT(each.repetition, 2);
  }
}

TEST(BaselineRecords, MustExist) {
  const std::vector<Record> records = {record("column_generation", 3, 200, 0, 1)};
  EXPECT_EQ(
      message_of<InvalidParameterError>([&] { baseline_records(records, {}, default_baselines(records)); }),
      "a ratio needs a baseline, and no method here is one; name one with --baseline");
  EXPECT_NE(
      message_of<UnknownNameError>([&] { baseline_records(records, {}, {"glkp"}); }).find("unknown baseline"),
      std::string::npos);
}

TEST(DefaultBaselines, AreThoseOfThePaperWhateverTheirLabel) {
  EXPECT_EQ(default_baselines(two_cells()), kGlpk);
  std::vector<Record> records = {record("column_generation", 3, 200, 0, 1), record("glpk_dual", 3, 200, 0, 1),
                                 record("clp_dual", 3, 200, 0, 1)};
  records[1].method = "lp";
  EXPECT_EQ(default_baselines(records), (std::vector<std::string>{"lp"}));
  EXPECT_TRUE(methods_of(records).is_competitor("lp"));
  EXPECT_FALSE(methods_of(records).is_competitor("column_generation"));
}

TEST(DefaultBaselines, AreAllBaselinesWhereThePapersAreMissing) {
  std::vector<Record> records = {record("glpk_dual", 3, 200, 0, 1), record("clp_dual", 3, 200, 0, 1),
                                 record("exact", 3, 200, 0, 1)};
  records[0].method_name = "newton";  // a label says nothing of the method
  records[0].role = Role::engine;
  EXPECT_EQ(default_baselines(records), (std::vector<std::string>{"clp_dual"}));
}

}  // namespace
}  // namespace raygauge::test_cell_ratio
