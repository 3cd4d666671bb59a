// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/columns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "raygauge/exceptions.h"
#include "results/schema/schema.h"
#include "tests/analysis/records.h"

namespace raygauge::test_columns {
namespace {

using testing::record;

double value(const std::string& name, const Record& record) {
  return number_of(analysis_column(name), record);
}

TEST(Columns, HoldAllOfTheFileAndNoNameTwice) {
  for (const auto& column : record_columns())
    EXPECT_NE(find_analysis_column(column.name), nullptr) << column.name;
  std::set<std::string> names;
  for (const AnalysisColumn& column : analysis_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(column.description.empty()) << column.name;
    for (const std::string& alias : column.aliases) EXPECT_TRUE(names.insert(alias).second) << alias;
  }
}

TEST(Columns, DeriveWhatTheirDescriptionsSay) {
  Record r = record("column_generation", 3, 200, 0, 2.5);
  r.lower = 1.5;
  r.upper = 2;
  r.distance = 1.75;
  r.exact_distance = 1.6;
  r.load_seconds = 0.004;
  r.counters.outer_iterations = 7;
  r.counters.ray_iterations = 11;
  EXPECT_DOUBLE_EQ(value("milliseconds", r), 2.5);
  EXPECT_DOUBLE_EQ(value("ms", r), 2.5);
  EXPECT_DOUBLE_EQ(value("us", r), 2500);
  EXPECT_DOUBLE_EQ(value("load_milliseconds", r), 4);
  EXPECT_DOUBLE_EQ(value("gap", r), 0.5);
  EXPECT_DOUBLE_EQ(value("relative_gap", r), 0.25);
  EXPECT_DOUBLE_EQ(value("error", r), 0.15);
  EXPECT_DOUBLE_EQ(value("relative_error", r), 0.15 / 1.6);
  EXPECT_EQ(value("K", r), 7);
  EXPECT_EQ(value("N_rs", r), 11);
  EXPECT_EQ(value("solved", r), 1);
}

TEST(Columns, HaveNoGapAtZeroAndAtInfinityAndNoneWithoutBounds) {
  Record r = record("column_generation", 3, 200, 0, 1);
  r.lower = r.upper = r.distance = r.exact_distance = std::numeric_limits<double>::infinity();
  EXPECT_EQ(value("gap", r), 0);
  EXPECT_EQ(value("relative_gap", r), 0);
  EXPECT_EQ(value("error", r), 0);
  r.lower = r.upper = 0;
  EXPECT_EQ(value("relative_gap", r), 0);
  r.lower = std::nan("");
  EXPECT_TRUE(std::isnan(value("relative_gap", r)));
}

TEST(Columns, GiveAnUnsolvedRecordAnInfiniteTimeAndKeepItsOtherValues) {
  Record r = record("column_generation", 3, 200, 0, 1);
  r.status = DistanceStatus::time_limit;
  EXPECT_TRUE(std::isinf(value("milliseconds", r)));
  EXPECT_TRUE(std::isinf(value("seconds", r)));
  EXPECT_EQ(value("n", r), 3);
  EXPECT_EQ(value("solved", r), 0);
  for (const auto status :
       {DistanceStatus::optimal, DistanceStatus::contains_origin, DistanceStatus::unreachable}) {
    r.status = status;
    EXPECT_TRUE(is_solved(r));
  }
}

TEST(Columns, ListTheKnownOnesForAnUnknownName) {
  const std::string message =
      testing::message_of<UnknownNameError>([] { analysis_column("milisecond", "rows"); });
  EXPECT_NE(message.find("rows: unknown column 'milisecond'; did you mean 'milliseconds'?"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find(" N_rs"), std::string::npos);
}

TEST(Columns, AreNumbersOrSaySo) {
  EXPECT_THROW(number_of(analysis_column("method"), Record()), InvalidParameterError);
}

TEST(Columns, ShowValuesAsShortText) {
  EXPECT_EQ(text_of(Value(1e-6)), "1e-6");
  EXPECT_EQ(text_of(Value(true)), "true");
  EXPECT_EQ(text_of(Value(std::int32_t{-4})), "-4");
  EXPECT_EQ(text_of(Value(std::string("column_generation"))), "column_generation");
}

}  // namespace
}  // namespace raygauge::test_columns
