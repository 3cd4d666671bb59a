// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/pivot/pivot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analysis/studies/pivot/pivot_table.h"
#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_pivot {
namespace {

using testing::add_records;
using testing::message_of;

/// column_generation and glpk_primal at n = 3, 10 and N = 200, 400; column_generation takes n·N/1000 ms ± 10
/// %, GLPK ten times that.
std::vector<Record> grid() {
  std::vector<Record> records;
  for (const int n : {10, 3}) {
    for (const int N : {200, 400}) {
      const double ms = n * N / 1000.0;
      add_records(records, "column_generation", n, N, {0.9 * ms, ms, 1.1 * ms});
      add_records(records, "glpk_primal", n, N, {9 * ms, 10 * ms, 11 * ms});
    }
  }
  return records;
}

PivotOptions options(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                     const std::string& value, const std::string& where = "") {
  PivotOptions result;
  result.rows = rows;
  result.columns = columns;
  result.value = value;
  if (!where.empty()) result.filter = Filter(where);
  return result;
}

double number(const Pivot& pivot, std::size_t row, std::size_t column) {
  return pivot.cell(row, column).value;
}

TEST(Pivot, AggregatesByRowsAndColumnsInNumericOrder) {
  const Pivot pivot = make_pivot(grid(), options({"n"}, {"N"}, "median ms", "method==column_generation"));
  ASSERT_EQ(pivot.row_keys.size(), 2U);
  EXPECT_EQ(std::get<std::int32_t>(pivot.row_keys[0][0]), 3);
  EXPECT_EQ(std::get<std::int32_t>(pivot.row_keys[1][0]), 10) << "as numbers, not as texts";
  EXPECT_DOUBLE_EQ(number(pivot, 0, 0), 0.6);
  EXPECT_DOUBLE_EQ(number(pivot, 0, 1), 1.2);
  EXPECT_DOUBLE_EQ(number(pivot, 1, 1), 4);
  EXPECT_TRUE(pivot.split_by.empty());
}

TEST(Pivot, IsSplitByWhatItsValueMustNotMix) {
  const Pivot pivot = make_pivot(grid(), options({"n"}, {"N"}, "median ms"));
  EXPECT_EQ(pivot.split_by, (std::vector<std::string>{"method"}));
  EXPECT_EQ(pivot.row_names, (std::vector<std::string>{"method", "n"}));
  ASSERT_EQ(pivot.row_keys.size(), 4U);
  EXPECT_EQ(std::get<std::string>(pivot.row_keys[0][0]), "column_generation") << "in order of appearance";
  EXPECT_DOUBLE_EQ(number(pivot, 2, 0), 6);
}

TEST(Pivot, MixesMethodsInCounts) {
  const Pivot pivot = make_pivot(grid(), options({"n"}, {}, "count"));
  ASSERT_EQ(pivot.cells.size(), 2U);
  EXPECT_EQ(number(pivot, 0, 0), 12);
}

TEST(Pivot, TakesSeveralRowsAndColumns) {
  const Pivot pivot = make_pivot(grid(), options({"method", "n"}, {"N", "repetition"}, "max ms"));
  EXPECT_EQ(pivot.row_keys.size(), 4U);
  EXPECT_EQ(pivot.column_keys.size(), 6U);
  EXPECT_DOUBLE_EQ(number(pivot, 0, 2), 0.66);
}

TEST(Pivot, OfRatiosDividesByTheBaselineOfEachCell) {
  const Pivot pivot = make_pivot(grid(), options({"n"}, {"N"}, "median ratio"));
  EXPECT_EQ(pivot.baselines, (std::vector<std::string>{"glpk_primal"}));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(pivot.cells[i].value, 0.1);
  EXPECT_TRUE(pivot.cells[0].interval.has_value());
}

TEST(Pivot, AggregatesTheRatiosOfSeveralCells) {
  std::vector<Record> records = grid();
  for (Record& record : records)
    if (record.method == "column_generation" && record.N == 400) record.seconds *= 4;
  EXPECT_DOUBLE_EQ(number(make_pivot(records, options({"n"}, {}, "geomean ratio")), 0, 0), 0.2);
  EXPECT_DOUBLE_EQ(number(make_pivot(records, options({"method"}, {}, "max ratio")), 0, 0), 0.4);
  EXPECT_DOUBLE_EQ(number(make_pivot(records, options({"n"}, {}, "median ratio")), 0, 0), 0.25);
  EXPECT_FALSE(make_pivot(records, options({"n"}, {}, "geomean ratio")).cells[0].interval.has_value());
}

TEST(Pivot, FindsTheBaselineThatTheFilterLeftOut) {
  const Pivot pivot =
      make_pivot(grid(), options({"n"}, {"N"}, "median ratio", "method==column_generation && n==3"));
  ASSERT_EQ(pivot.row_keys.size(), 1U);
  EXPECT_DOUBLE_EQ(number(pivot, 0, 1), 0.1);
}

TEST(Pivot, NeverAveragesDisagreeingRecordsInButCountsThem) {
  std::vector<Record> records = grid();
  records[2].agrees = false;  // column_generation, n=10, N=200, the slowest
  const Pivot pivot = make_pivot(records, options({"n"}, {"N"}, "max ms", "method==column_generation"));
  EXPECT_DOUBLE_EQ(number(pivot, 1, 0), 2);
  EXPECT_EQ(pivot.cell(1, 0).disagreeing, 1U);
  EXPECT_EQ(number(make_pivot(records, options({}, {}, "disagreements")), 0, 0), 1);
  const Table table = pivot_table(pivot);
  EXPECT_EQ(table.rows[1].cells[1].text, "2*");
  ASSERT_EQ(table.notes.size(), 1U);
  EXPECT_EQ(table.notes[0], "* 1 record in disagreement with other methods, left out: n=10 N=200 1 of 3");
}

TEST(Pivot, CountsUnsolvedSolvesAsInfinitelySlow) {
  std::vector<Record> records = grid();
  records[0].status = DistanceStatus::time_limit;
  Pivot pivot = make_pivot(records, options({"n"}, {"N"}, "median ms", "method==column_generation"));
  EXPECT_DOUBLE_EQ(number(pivot, 1, 0), 2.2) << "of 2, 2.2 and infinity";
  EXPECT_EQ(pivot_table(pivot).notes[0],
            "* 1 record unsolved (stopped at a limit), counted as infinitely slow: n=10 N=200 1 of 3");
  records[1].status = DistanceStatus::precision_limit;
  pivot = make_pivot(records, options({"n"}, {"N"}, "median ms", "method==column_generation"));
  EXPECT_TRUE(std::isinf(number(pivot, 1, 0)));
  EXPECT_EQ(pivot_table(pivot).rows[1].cells[1].text, "unsolved*");
  EXPECT_EQ(number(make_pivot(records, options({}, {}, "failures")), 0, 0), 2);
}

TEST(Pivot, ShowsWhereNothingCanBeAggregated) {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2});
  add_records(records, "column_generation", 4, 400, {1, 2});
  records[0].agrees = records[1].agrees = false;
  records[2].lower = records[3].lower = std::numeric_limits<double>::quiet_NaN();
  const Table table = pivot_table(make_pivot(records, options({"n"}, {"N"}, "max gap")));
  EXPECT_EQ(table.rows[0].cells[1].text, "disagree");
  EXPECT_EQ(table.rows[0].cells[2].text, "") << "no record there";
  EXPECT_EQ(table.rows[1].cells[2].text, "none");
  EXPECT_EQ(table.notes.size(), 2U);
}

TEST(Pivot, AsATableNamesColumnsAndGroups) {
  const Table table = pivot_table(make_pivot(grid(), options({"n"}, {"N"}, "median ms")));
  EXPECT_EQ(table.title, "median milliseconds");
  EXPECT_EQ(table.header, (std::vector<std::vector<std::string>>{{"method", "n", "N=200", "N=400"}}));
  EXPECT_EQ(table.key_columns, 2U);
  EXPECT_TRUE(table.rows[2].starts_group);
  EXPECT_FALSE(table.rows[1].starts_group);
  EXPECT_EQ(table.rows[0].cells[2].text, "0.600");
  EXPECT_DOUBLE_EQ(table.rows[0].cells[2].number, 0.6);
  EXPECT_EQ(table.notes.back(), "split by method, which the value must not mix");
}

TEST(Pivot, ShowsIntervalsOfMedians) {
  const Table table =
      pivot_table(make_pivot(grid(), options({"n"}, {"N"}, "median ms", "method==column_generation")), true);
  EXPECT_EQ(table.rows[0].cells[1].text, "0.600 [0.540, 0.660]");
}

TEST(Pivot, SaysWhatIsWrong) {
  const auto complaint = [](const PivotOptions& o) {
    return message_of<Error>([&] { make_pivot(grid(), o); });
  };
  EXPECT_EQ(complaint(options({"n"}, {}, "median ratio", "method==glpk_primal")),
            "there is nothing to tabulate: the baselines are all there is, and their own ratio says nothing");
  EXPECT_EQ(complaint(options({"n"}, {}, "median ms", "n==99")),
            "there is nothing to tabulate: no record passes the filter 'n==99'");
  EXPECT_EQ(complaint(options({"repetition"}, {}, "median ratio")),
            "a ratio compares whole cells (generator, n, N, tolerance, method) and cannot be split by "
            "'repetition'");
  EXPECT_NE(complaint(options({"m"}, {}, "count")).find("rows: unknown column 'm'"), std::string::npos);
  EXPECT_NE(complaint(options({}, {"m"}, "count")).find("columns: unknown column 'm'"), std::string::npos);
  EXPECT_THROW(make_pivot({}, options({"n"}, {}, "count")), EmptySetError);
}

}  // namespace
}  // namespace raygauge::test_pivot
