// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/pool.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "analysis/data/cell_ratio.h"
#include "analysis/render/table.h"
#include "analysis/studies/figures.h"
#include "analysis/studies/pivot/pivot.h"
#include "analysis/studies/pivot/pivot_table.h"
#include "tests/analysis/records.h"

namespace raygauge::test_pool {
namespace {

using testing::record;

/// Pair k of two methods takes k + 1 and 2 (k + 1) milliseconds, twice each.
std::vector<Record> pairs(int count) {
  std::vector<Record> records;
  for (int k = 0; k < count; ++k) {
    for (const int repetition : {0, 1}) {
      for (const double factor : {1.0, 2.0}) {
        Record& made = records.emplace_back(
            record(factor == 1 ? "newton" : "glpk_dual", 3, 10 + k % 2, repetition, factor * (k + 1)));
        made.generator = "files";
        made.generator_parameters =
            "family=" + std::string(k % 2 == 0 ? "even" : "odd") + " pair=p" + std::to_string(k);
      }
    }
  }
  return records;
}

std::string table_of(const std::vector<Record>& records, const std::string& rows, const std::string& value) {
  PivotOptions options;
  options.rows = {rows};
  options.value = value;
  RenderOptions render_options;
  render_options.format = TableFormat::csv;
  return render(pivot_table(make_pivot(records, options), false, true), render_options);
}

TEST(Pool, ManyPairsOfOnesOwnAreInstancesOfOneProblem) {
  const std::vector<Record> records = pairs(20);
  const Pool pool(records);
  EXPECT_EQ(pool.size(), 20U);
  std::set<int> repetitions;
  for (const Record& each : pool(records)) {
    EXPECT_EQ(each.generator_parameters, "pairs=20");
    repetitions.insert(each.repetition);
  }
  EXPECT_EQ(repetitions.size(), 40U) << "each instance has its own number";
}

TEST(Pool, FewPairsAndOtherGeneratorsStayAsTheyAre) {
  EXPECT_EQ(Pool(pairs(8)).size(), 0U);
  std::vector<Record> others = pairs(20);
  for (Record& each : others) each.generator = "example2";
  EXPECT_EQ(Pool(others).size(), 0U);
}

TEST(Pool, ATableOfManyPairsHasOneLineAMethod) {
  EXPECT_EQ(table_of(pairs(2000), "method", "max ms"),
            "method,max milliseconds\nnewton,2000\nglpk_dual,4000\n");
  EXPECT_EQ(table_of(pairs(20), "family", "count"), "family,count\neven,40\nodd,40\n");
}

TEST(Pool, RatiosOfAllPairsAreAggregated) {
  const std::string table = table_of(pairs(20), "method", "geomean ratio");
  EXPECT_EQ(table.substr(table.find('\n') + 1), "newton,0.5\n");
}

TEST(Pool, ShiftedMeansAndSharesAreValues) {
  std::vector<Record> records = pairs(9);
  records.front().status = DistanceStatus::time_limit;  // newton's first of 18
  records[2].agrees = false;
  const std::string solved = table_of(records, "method", "share solved");
  EXPECT_NE(solved.find("newton,0.944444"), std::string::npos) << solved;
  EXPECT_NE(solved.find("glpk_dual,1"), std::string::npos) << solved;
  const std::string shifted = table_of(pairs(9), "method", "sgm10 ms");
  EXPECT_NE(shifted.find("newton,4.77"), std::string::npos) << shifted;
}

CellTimes times_of_pool(const std::vector<Record>& records) {
  return cell_times(Pool(records)(records)).front();
}

TEST(Pool, TheMiddleOfItsTimesIsTheGeometricMean) {
  std::vector<Record> records;
  testing::add_records(records, "newton", 3, 10, {1, 10, 100, 1000, 1, 10, 100, 1000, 10, 100});
  for (Record& each : records) {
    each.generator = "files";
    each.generator_parameters = "pair=p" + std::to_string(each.repetition);
  }
  const Center center = center_of(times_of_pool(records));
  EXPECT_NEAR(center.seconds, 1e-3 * std::pow(10, 1.5), 1e-12);
  EXPECT_LT(center.interval.lower, center.seconds);
  EXPECT_GT(center.interval.upper, center.seconds);
  for (Record& each : records) each.generator = "example2";
  EXPECT_EQ(center_of(cell_times(records).front()).seconds, 1e-3) << "the median of one repetition";
}

TEST(Pool, TheMiddleIsInfiniteWhereHalfIsUnsolved) {
  std::vector<Record> records = pairs(20);
  std::size_t unsolved = 0;
  for (Record& each : records) {
    if (each.method != "newton" || each.N != 10) continue;
    if (++unsolved <= 9) each.status = DistanceStatus::time_limit;
  }
  const CellTimes most = times_of_pool(records);  // 9 of 20 unsolved
  EXPECT_TRUE(std::isfinite(center_of(most).seconds));
  unsolved = 0;
  for (Record& each : records)
    if (each.method == "newton" && each.N == 10 && ++unsolved <= 10) each.status = DistanceStatus::time_limit;
  EXPECT_TRUE(std::isinf(center_of(times_of_pool(records)).seconds));
}

TEST(Pool, FiguresShowItAsOneProblem) {
  const std::vector<Record> records = pairs(40);  // N = 10 and 11
  FigureOptions options;
  const auto drawn = [&](const char* figure) {
    return draw(figure_named(figure), records, options, ImageFormat::svg);
  };
  const std::string times = drawn("time_vs_N").front();
  EXPECT_NE(times.find("geometric mean time of a solve"), std::string::npos);
  for (const char* map : {"ratio_heatmap", "crossover"}) EXPECT_EQ(drawn(map).size(), 1U) << map;
  EXPECT_NE(drawn("ratio_heatmap").front().find(">50<"), std::string::npos) << "half of glpk_dual's time";
  options.filter = Filter("family==even || pair==p1");
  EXPECT_EQ(drawn("crossover").size(), 1U) << "the filter still knows the pairs";
}

}  // namespace
}  // namespace raygauge::test_pool
