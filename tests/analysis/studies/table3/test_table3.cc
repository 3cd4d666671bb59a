// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/table3/table3.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/studies/table3/table3_tables.h"
#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_table3 {
namespace {

using testing::add_records;
using testing::message_of;

/// n = 3, N = 200 and 400: column_generation at 10 % (more than half of the paper's 19 %) and 1 % of GLPK's
/// dual simplex.
std::vector<Record> sample() {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {0.1, 0.2, 0.3});
  add_records(records, "glpk_primal", 3, 200, {3, 4, 5});
  add_records(records, "glpk_dual", 3, 200, {1, 2, 3});
  add_records(records, "column_generation", 3, 400, {0.04, 0.05, 0.06});
  add_records(records, "glpk_primal", 3, 400, {7, 8, 9});
  add_records(records, "glpk_dual", 3, 400, {4, 5, 6});
  return records;
}

std::string text_of(const Table3& table3) {
  std::string text;
  for (const Table& table : table3_tables(table3)) text += render(table);
  return text;
}

TEST(Table3, ABaselineUnderALabelOfTheUsersIsNoMethodOfOurs) {
  std::vector<Record> records = sample();
  for (Record& record : records)
    if (record.method == "glpk_dual") record.method = "lp";
  const Table3 table3 = make_table3(records);
  ASSERT_EQ(table3.methods.size(), 1U);
  EXPECT_EQ(table3.methods.front().method, "column_generation");
  EXPECT_EQ(table3.baselines, (std::vector<std::string>{"glpk_primal", "lp"}));

  // Nor where another baseline is named.
  EXPECT_EQ(make_table3(records, {}, {"glpk_primal"}).methods.size(), 1U);
}

TEST(Table3, ReadsAsInThePaperWithItsNumbersBelow) {
  EXPECT_EQ(
      text_of(make_table3(sample())),
      R"(Table III, column_generation: median ms of a solve (ratio to the better of glpk_primal, glpk_dual)

                       N=200             400
--------------------------------------------
n=3  measured  0.200 (0.10)*  0.0500 (0.010)
     paper       1.36 (0.19)     1.52 (0.15)

* more than half of the paper's ratio: n=3 N=200
Table III, summary

                                     column_generation
------------------------------------------------------
cells                                                2
geometric mean of the ratios                    0.0316
the paper's, same cells                          0.169
worst cell                          0.100 at n=3 N=200
cells above half the paper's ratio              1 of 2
largest certified relative gap                  5.0e-7
records not certified to 1e-6                   0 of 6
records unsolved                                0 of 6
records in disagreement                         0 of 6

agreement: all 18 records agree, baselines included
)");
}

TEST(Table3, SummarisesEachMethod) {
  const Table3 table3 = make_table3(sample());
  ASSERT_EQ(table3.methods.size(), 1U);
  const Table3Method& method = table3.methods[0];
  EXPECT_EQ(method.compared, 2U);
  EXPECT_DOUBLE_EQ(method.geometric_mean, std::sqrt(0.1 * 0.01));
  EXPECT_DOUBLE_EQ(method.paper_geometric_mean, std::sqrt(0.19 * 0.15));
  ASSERT_EQ(method.above_half.size(), 1U);
  EXPECT_EQ(method.above_half[0].times.cell.N, 200);
}

TEST(Table3, ShowsWhatDisagreesIsUnsolvedOrUncertified) {
  std::vector<Record> records = sample();
  records[0].agrees = false;
  records[1].status = DistanceStatus::time_limit;
  records[1].lower = std::nan("");
  const Table3 table3 = make_table3(records);
  EXPECT_EQ(table3.disagreeing, 1U);
  EXPECT_EQ(table3.methods[0].unsolved, 1U);
  EXPECT_EQ(table3.methods[0].above_tolerance, 1U);
  const std::string text = text_of(table3);
  EXPECT_NE(
      text.find("! unsolved solves count as infinitely slow, disagreeing ones are left out: n=3 N=200 1 "
                "unsolved, n=3 N=200 1 in disagreement"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("agreement: 1 of 18 records DISAGREE"), std::string::npos) << text;
}

TEST(Table3, LeavesOtherTolerancesGeneratorsAndCompetitorsOut) {
  std::vector<Record> records = sample();
  add_records(records, "column_generation", 3, 600, {1});
  records.back().tolerance = 1e-3;
  add_records(records, "column_generation", 3, 800, {1});
  records.back().generator = "needle";
  add_records(records, "clp_dual", 3, 200, {1, 1, 1});
  const Table3 table3 = make_table3(records);
  ASSERT_EQ(table3.methods.size(), 1U);
  EXPECT_EQ(table3.methods[0].cells.size(), 2U);
}

TEST(Table3, HasCellsThatThePaperLacks) {
  std::vector<Record> records = sample();
  add_records(records, "column_generation", 3, 300, {1, 1, 1});
  add_records(records, "glpk_dual", 3, 300, {2, 2, 2});
  const Table3 table3 = make_table3(records);
  EXPECT_EQ(table3.methods[0].cells.size(), 3U);
  EXPECT_EQ(table3.methods[0].compared, 2U);
}

TEST(Table3, SummarisesAGridOfOnesOwnByAllItsRatios) {
  std::vector<Record> records;
  for (const int N : {50, 100}) {
    add_records(records, "column_generation", 3, N, {1, 1, 1});
    add_records(records, "glpk_dual", 3, N, {4, 4, 4});
  }
  const Table3 own = make_table3(records);
  EXPECT_EQ(own.methods[0].measured, 2U);
  EXPECT_EQ(own.methods[0].compared, 0U);
  EXPECT_DOUBLE_EQ(own.methods[0].geometric_mean, 0.25);
  const std::string text = text_of(own);
  EXPECT_EQ(text.find("none"), std::string::npos) << text;
  EXPECT_EQ(text.find("paper"), std::string::npos) << text;

  add_records(records, "column_generation", 3, 200, {1, 1, 1});
  add_records(records, "glpk_dual", 3, 200, {2, 2, 2});
  const Table3 mixed = make_table3(records);
  EXPECT_DOUBLE_EQ(mixed.methods[0].geometric_mean, std::cbrt(0.25 * 0.25 * 0.5));
  EXPECT_DOUBLE_EQ(mixed.methods[0].compared_geometric_mean, 0.5);
  EXPECT_NE(text_of(mixed).find("in the cells of the paper"), std::string::npos) << text_of(mixed);
}

TEST(Table3, AsCsvHasARowForEachMethodAndCell) {
  RenderOptions options;
  options.format = TableFormat::csv;
  const std::string csv = render(table3_long_table(make_table3(sample())), options);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "method,n,N,milliseconds,ratio,ratio_lower,ratio_upper,baseline,baseline_milliseconds,"
            "paper_milliseconds,paper_ratio,records,unsolved,disagreeing");
  EXPECT_NE(csv.find("column_generation,3,200,0.2,0.1,"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",glpk_dual,2,1.36,0.19,3,0,0\n"), std::string::npos) << csv;
}

TEST(Table3, SaysWhatItLacks) {
  std::vector<Record> records = sample();
  EXPECT_EQ(message_of<EmptySetError>([&] { make_table3(records, Filter("method==glpk_dual")); }),
            "Table III compares methods of raygauge with GLPK; the records have none of them");
  EXPECT_EQ(message_of<EmptySetError>([&] { make_table3(records, Filter("n==9")); }),
            "no record passes the filter 'n==9'");
  for (Record& record : records) record.tolerance = 1e-3;
  EXPECT_EQ(message_of<EmptySetError>([&] { make_table3(records); }),
            "Table III needs records at tolerance 1e-6; there are none");
  records = sample();
  records[0].generator_parameters = "separation=3";
  EXPECT_EQ(message_of<InvalidParameterError>([&] { make_table3(records); }),
            "Table III needs instances of one generator, the records have several (example2 separation=1.5; "
            "example2 separation=3); choose with --where");
}

}  // namespace
}  // namespace raygauge::test_table3
