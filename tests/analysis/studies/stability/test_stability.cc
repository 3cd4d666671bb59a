// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/stability/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_stability {
namespace {

using testing::message_of;
using testing::record;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A solve of family `thin` whose true distance is 4, claimed to be 4 and certified to a relative width of
/// 2^-21 (4.8e-7) at tolerance 1e-6.
Record thin(const std::string& method, int repetition, double milliseconds) {
  Record result = record(method, 3, 200, repetition, milliseconds);
  result.generator = "thin";
  result.exact_distance = result.distance = result.upper = 4;
  result.lower = 4 - 0x1p-19;
  return result;
}

/// column_generation: right and certified; stopped at a limit; right, but certified to 0.5 only. glpk_dual:
/// off by 1/4, no bounds; off by 5e-6, within the allowance.
std::vector<Record> sample() {
  std::vector<Record> records = {thin("column_generation", 0, 1), thin("column_generation", 1, 3),
                                 thin("column_generation", 2, 2), thin("glpk_dual", 0, 10),
                                 thin("glpk_dual", 1, 20)};
  records[1].status = DistanceStatus::precision_limit;
  records[1].distance = 3.5;
  records[1].lower = 3;
  records[2].lower = 2;
  records[3].distance = 5;
  records[3].lower = kNaN;
  records[4].distance = 4.00002;
  return records;
}

TEST(Stability, SummarisesEachMethodOnEachFamily) {
  const Stability stability = make_stability(sample());
  ASSERT_EQ(stability.size(), 1U);
  EXPECT_EQ(stability[0].tolerance, 1e-6);
  ASSERT_EQ(stability[0].rows.size(), 2U);

  const StabilityRow& column_generation = stability[0].rows[0];
  EXPECT_EQ(column_generation.family, "thin");
  EXPECT_EQ(column_generation.method, "column_generation");
  EXPECT_EQ(column_generation.solves, 3U);
  EXPECT_EQ(column_generation.certified, 1U);
  EXPECT_EQ(column_generation.worst_width, 0.5);
  EXPECT_EQ(column_generation.worst_true_error, 0) << "a record that stopped at a limit claims no distance";
  EXPECT_EQ(column_generation.wrong, 0U);
  EXPECT_EQ(column_generation.failures, 1U);
  EXPECT_EQ(column_generation.median_seconds, 2e-3) << "1 ms, 2 ms and one that never came to an answer";

  const StabilityRow& glpk = stability[0].rows[1];
  EXPECT_EQ(glpk.certified, 1U);
  EXPECT_EQ(glpk.worst_width, kInfinity);
  EXPECT_EQ(glpk.worst_true_error, 0.25);
  EXPECT_EQ(glpk.wrong, 1U);
  EXPECT_EQ(glpk.failures, 0U);
}

TEST(Stability, HasTotalsOverAllFamilies) {
  std::vector<Record> records = sample();
  records.push_back(thin("column_generation", 0, 5));
  records.back().generator = "flat";
  const Stability stability = make_stability(records);
  ASSERT_EQ(stability[0].rows.size(), 3U);
  EXPECT_EQ(stability[0].rows[2].family, "flat");
  ASSERT_EQ(stability[0].totals.size(), 2U);
  EXPECT_EQ(stability[0].totals[0].family, "");
  EXPECT_EQ(stability[0].totals[0].solves, 4U);
  EXPECT_EQ(stability[0].totals[0].certified, 2U);
  EXPECT_EQ(stability[0].totals[0].median_seconds, 3.5e-3)
      << "1, 2, 5 ms and an unsolved one: type 7 gives (2 + 5) / 2";
}

TEST(Stability, KeepsTolerancesApart) {
  std::vector<Record> records = {thin("column_generation", 0, 1), thin("column_generation", 0, 1)};
  records[1].tolerance = 1e-12;
  const Stability stability = make_stability(records);
  ASSERT_EQ(stability.size(), 2U);
  EXPECT_EQ(stability[0].tolerance, 1e-12);
  EXPECT_EQ(stability[0].rows[0].certified, 0U) << "certified to 4.8e-7";
  EXPECT_EQ(stability[1].rows[0].certified, 1U);
}

TEST(Stability, TakesTheTruthFromExactRecordsThatTheFilterLeavesOut) {
  std::vector<Record> records = {thin("column_generation", 0, 1), thin("column_generation", 1, 1),
                                 thin("exact", 0, 1)};
  for (Record& record : records) record.exact_distance = kNaN;
  records[2].distance = 8;
  const Stability stability = make_stability(records, Filter("method!=exact"));
  ASSERT_EQ(stability[0].rows.size(), 1U);
  EXPECT_EQ(stability[0].rows[0].truth_known, 1U);
  EXPECT_EQ(stability[0].rows[0].worst_true_error, 0.5);
  EXPECT_EQ(stability[0].rows[0].wrong, 1U);
}

TEST(Stability, CallsAnAnswerWrongBeyondTenTimesTheTolerance) {
  Record record = thin("glpk_dual", 0, 1);
  record.distance = 4 * (1 + 9e-6);
  EXPECT_FALSE(is_wrong(record, 4));
  record.distance = 4 * (1 + 11e-6);
  EXPECT_TRUE(is_wrong(record, 4));
  EXPECT_FALSE(is_wrong(record, kNaN));
  record.status = DistanceStatus::precision_limit;
  EXPECT_FALSE(is_wrong(record, 4)) << "no answer";
  record.status = DistanceStatus::unreachable;
  EXPECT_TRUE(is_wrong(record, 4));
  EXPECT_FALSE(is_wrong(record, kInfinity));
}

TEST(Stability, CallsBoundsThatExcludeTheTruthWrongWhateverTheStatus) {
  Record record = thin("column_generation", 0, 1);
  record.lower = std::nextafter(4.0, 5.0);
  EXPECT_TRUE(is_wrong(record, 4));
  record.status = DistanceStatus::time_limit;
  EXPECT_TRUE(is_wrong(record, 4));
  record.lower = kNaN;
  EXPECT_FALSE(is_wrong(record, 4));
  record.upper = std::nextafter(4.0, 3.0);
  EXPECT_TRUE(is_wrong(record, 4));
  record.role = Role::baseline;
  EXPECT_FALSE(is_wrong(record, 4)) << "a competitor's bounds are not its own";
}

TEST(Stability, NeedsRecords) {
  EXPECT_EQ(message_of<EmptySetError>([] { make_stability({}); }), "no records");
  EXPECT_EQ(message_of<EmptySetError>([] { make_stability(sample(), Filter("n==9")); }),
            "no record passes the filter 'n==9'");
}

TEST(StabilityTables, ReadAsOneTableWithItsTotals) {
  std::vector<Record> records = sample();
  records.push_back(thin("column_generation", 3, 4));
  records.back().exact_distance = kNaN;
  const std::vector<Table> tables = stability_tables(make_stability(records));
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(render(tables[0]),
            R"(Stability at tolerance 1e-6

family        method             solves  certified  worst width  worst true error  wrong  failures  median ms
-------------------------------------------------------------------------------------------------------------
thin          column_generation       4     50.0 %         0.50                 0      0         1       3.00
              glpk_dual               2     50.0 %         none              0.25      1         0       15.0

all families  column_generation       4     50.0 %         0.50                 0      0         1       3.00
              glpk_dual               2     50.0 %         none              0.25      1         0       15.0

certified: solved with proven bounds of relative width at most 1e-6; worst width: over all solves, none where a bound is missing
wrong: an answer off by a relative error of more than 1e-5, or bounds that exclude the truth; failures: stopped at a limit without an answer
a family is counted over all its parameters, n and N; --where chooses among them
the truth is unknown for 1 of 6 solves, which therefore cannot be found wrong
)");
}

TEST(StabilityTables, RoundTheCertifiedShareDown) {
  std::vector<Record> records;
  for (int i = 0; i < 3000; ++i) records.push_back(thin("column_generation", i, 1));
  records[7].status = DistanceStatus::time_limit;
  const std::string text = render(stability_tables(make_stability(records))[0]);
  EXPECT_NE(text.find("99.9 %"), std::string::npos) << text;
  EXPECT_EQ(text.find("100 %"), std::string::npos) << text;
}

TEST(StabilityTables, AsCsvHaveARowForEachToleranceFamilyAndMethod) {
  RenderOptions options;
  options.format = TableFormat::csv;
  EXPECT_EQ(
      render(stability_long_table(make_stability(sample())), options),
      "tolerance,family,method,solves,certified,certified_share,worst_width,truth_known,worst_true_error,"
      "wrong,failures,median_milliseconds\n"
      "1e-6,thin,column_generation,3,1,0.3333333333333333,0.5,3,0,0,1,2\n"
      "1e-6,thin,glpk_dual,2,1,0.5,inf,2,0.25,1,0,15\n"
      "1e-6,all,column_generation,3,1,0.3333333333333333,0.5,3,0,0,1,2\n"
      "1e-6,all,glpk_dual,2,1,0.5,inf,2,0.25,1,0,15\n");
}

TEST(IsWrong, AllowsTheTruthItsOwnRounding) {
  Record record = thin("column_generation", 0, 1);
  const auto is_wrong_at = [&](double point, const char* generator) {
    record.generator = generator;
    record = testing::with_facts(record);
    record.lower = record.distance = record.upper = point;
    return is_wrong(record, 4);
  };
  EXPECT_FALSE(is_wrong_at(std::nextafter(4, 5), "example1"));
  EXPECT_FALSE(is_wrong_at(std::nextafter(4, 3), "example1"));
  EXPECT_TRUE(is_wrong_at(std::nextafter(4, 5), "hard_needle")) << "whose truth is exact";
  EXPECT_TRUE(is_wrong_at(4 * (1 + 0x1p-44), "example1")) << "more than Example 1's 2^-46";
  EXPECT_TRUE(is_wrong_at(4 * (1 - 0x1p-44), "example1"));
  record.exact_distance = kNaN;  // proven by the method exact
  EXPECT_TRUE(is_wrong_at(std::nextafter(4, 5), "example1"));
}

}  // namespace
}  // namespace raygauge::test_stability
