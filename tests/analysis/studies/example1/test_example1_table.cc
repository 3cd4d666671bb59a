// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/example1/example1_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_example1_table {
namespace {

using testing::record;

/// A solve of Example 1 in contact, off by half the tolerance, with the paper's K and N_rs of Table I at
/// 1e-6.
Record contact(const std::string& method, const std::string& roles, double tolerance, double microseconds) {
  Record result = record(method, 3, 1, 0, microseconds / 1e3);
  result.generator = "example1";
  result.generator_parameters = "distance=1 roles=" + roles;
  result.tolerance = tolerance;
  result.exact_distance = 1;
  result.distance = result.upper = 1 + tolerance / 2;
  result.lower = 1;
  result.counters.outer_iterations = 2;
  result.counters.ray_iterations = 43;
  return result;
}

std::vector<Record> sample() {
  return {
      contact("zheng_yamane", "cone_ellipsoid", 1e-6, 4), contact("zheng_yamane", "cone_ellipsoid", 1e-2, 2),
      contact("nlopt_slsqp", "cone_ellipsoid", 1e-6, 16), contact("glpk_dual", "cone_ellipsoid", 1e-6, 32),
      contact("zheng_yamane", "ellipsoid_cone", 1e-6, 8)};
}

TEST(Example1Table, DividesTimesByTheBestBaselineAtTheSameTolerance) {
  const Example1Table table = make_example1_table(sample(), Example1Roles::cone_ellipsoid);
  EXPECT_EQ(table.baselines, (std::vector<std::string>{"nlopt_slsqp", "glpk_dual"}));
  ASSERT_EQ(table.curves.size(), 3U);
  EXPECT_TRUE(std::isnan(table.time_ratio(table.curves[0].points[0]))) << "no baseline at 1e-2";
  EXPECT_DOUBLE_EQ(table.time_ratio(table.curves[0].points[1]), 0.25);
  const Example1Table other = make_example1_table(sample(), Example1Roles::cone_ellipsoid, {}, {"glpk_dual"});
  EXPECT_DOUBLE_EQ(other.time_ratio(other.curves[0].points[1]), 0.125);
}

TEST(Example1Table, KeepsTheRolesApart) {
  const Example1Table table = make_example1_table(sample(), Example1Roles::ellipsoid_cone);
  ASSERT_EQ(table.curves.size(), 1U);
  EXPECT_DOUBLE_EQ(table.curves[0].points[0].mean_seconds, 8e-6);
  EXPECT_TRUE(table.baselines.empty());
}

TEST(Example1Table, ShowsThePapersNumbersBesideAndComparesThem) {
  const std::vector<Table> tables =
      example1_tables(make_example1_table(sample(), Example1Roles::cone_ellipsoid));
  ASSERT_EQ(tables.size(), 4U);
  const std::string ours = render(tables[0]);
  EXPECT_NE(ours.find("Table I, zheng_yamane"), std::string::npos) << ours;
  EXPECT_NE(ours.find("1.74e-7"), std::string::npos) << ours;
  EXPECT_NE(ours.find("42.67"), std::string::npos) << ours;
  const std::string theirs = render(tables[1]);
  EXPECT_NE(theirs.find("6.39e-9"), std::string::npos) << theirs;
  const std::string summary = render(tables.back());
  EXPECT_NE(summary.find("0 of 2"), std::string::npos) << summary;
  EXPECT_NE(summary.find("+1 … +186 %"), std::string::npos) << "43 / 42.67 and 43 / 15.03:\n" << summary;
}

TEST(Example1Table, HoldsOnlyThePapersOwnAlgorithmAgainstIt) {
  std::vector<Record> records = sample();
  for (const char* method : {"zheng_yamane_published", "column_generation"})
    records.push_back(contact(method, "cone_ellipsoid", 1e-2, 2));  // N_rs 43, the paper's 15.03: +186 %
  records.end()[-2].method_parameters = "max_iterations=0 stop_rule=published_sigma";
  const std::vector<Table> tables =
      example1_tables(make_example1_table(records, Example1Roles::cone_ellipsoid));
  const Table& summary = tables.back();
  const auto cell = [&](const std::string& row, const std::string& method) {
    const auto column = std::find(summary.header[0].begin(), summary.header[0].end(), method);
    const auto line = std::find_if(summary.rows.begin(), summary.rows.end(),
                                   [&](const TableRow& each) { return each.cells[0].text == row; });
    return line->cells.at(static_cast<std::size_t>(column - summary.header[0].begin()));
  };
  EXPECT_EQ(cell("N_rs against the paper's", "zheng_yamane_published").emphasis, Emphasis::alarm);
  EXPECT_EQ(cell("N_rs against the paper's", "zheng_yamane").emphasis, Emphasis::none) << "stops elsewhere";
  EXPECT_EQ(cell("N_rs against the paper's", "column_generation").text, "");
  EXPECT_EQ(cell("N_rs against the paper's", "glpk_dual").text, "");
}

TEST(Example1Table, WritesEveryNumberForCsv) {
  RenderOptions csv;
  csv.format = TableFormat::csv;
  const std::string text =
      render(example1_long_table(make_example1_table(sample(), Example1Roles::cone_ellipsoid)), csv);
  EXPECT_NE(text.find("method,tolerance,solves,error,microseconds,K,N_rs,"), std::string::npos) << text;
  EXPECT_NE(text.find("zheng_yamane,1e-6,1,"), std::string::npos) << text;
}

TEST(Example1Table, NeedsRecordsOfExample1AndKnownBaselines) {
  EXPECT_THROW(make_example1_table({record("column_generation", 3, 1, 0, 1)}, Example1Roles::cone_ellipsoid),
               EmptySetError);
  EXPECT_THROW(make_example1_table(sample(), Example1Roles::cone_ellipsoid, Filter("n==4")), EmptySetError);
  EXPECT_THROW(make_example1_table(sample(), Example1Roles::cone_ellipsoid, {}, {"glpk"}), UnknownNameError);
}

}  // namespace
}  // namespace raygauge::test_example1_table
