// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/analysis/records.h"

namespace raygauge::test_truth {
namespace {

using testing::record;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A record of an instance whose generator does not know the truth.
Record unknown(const std::string& method, int repetition, double distance) {
  Record result = record(method, 3, 200, repetition, 1);
  result.distance = distance;
  result.exact_distance = kNaN;
  return result;
}

Record with_status(Record record, DistanceStatus status) {
  record.status = status;
  return record;
}

TEST(Truth, IsTheGeneratorsOwnBeforeAnyMethods) {
  Record exact = record("exact", 3, 200, 0, 1);
  exact.distance = 5;
  EXPECT_EQ(Truth({exact})(record("column_generation", 3, 200, 0, 1)), 2);
}

TEST(Truth, IsElseWhatTheExactMethodProvedOfTheSameInstanceAtAnyTolerance) {
  Record exact = unknown("exact", 0, 5);
  exact.tolerance = 1e-3;
  const Truth truth({unknown("column_generation", 0, 4), exact, unknown("exact", 1, 6)});
  EXPECT_EQ(truth(unknown("column_generation", 0, 4)), 5);
  EXPECT_EQ(truth(unknown("column_generation", 1, 4)), 6);
  EXPECT_TRUE(std::isnan(truth(unknown("column_generation", 2, 4))));
  Record other = unknown("column_generation", 0, 4);
  other.generator_parameters = "separation=3";
  EXPECT_TRUE(std::isnan(truth(other)));
}

TEST(Truth, IsZeroOrInfiniteWhereTheExactMethodSaysSoAndUnknownWhereItStopped) {
  const Truth truth({with_status(unknown("exact", 0, 7), DistanceStatus::contains_origin),
                     with_status(unknown("exact", 1, 7), DistanceStatus::unreachable),
                     with_status(unknown("exact", 2, 7), DistanceStatus::time_limit)});
  EXPECT_EQ(truth(unknown("column_generation", 0, 1)), 0);
  EXPECT_EQ(truth(unknown("column_generation", 1, 1)), kInfinity);
  EXPECT_TRUE(std::isnan(truth(unknown("column_generation", 2, 1))));
}

TEST(TrueError, IsRelativeExceptToZero) {
  EXPECT_DOUBLE_EQ(true_error(unknown("column_generation", 0, 3), 4), 0.25);
  EXPECT_DOUBLE_EQ(true_error(unknown("column_generation", 0, 0.5), 0), 0.5);
  EXPECT_EQ(true_error(unknown("column_generation", 0, 4), 4), 0);
}

TEST(TrueError, IsInfiniteWhereOneIsReachableAndTheOtherNot) {
  const Record unreachable = with_status(unknown("column_generation", 0, 1), DistanceStatus::unreachable);
  EXPECT_EQ(true_error(unreachable, 4), kInfinity);
  EXPECT_EQ(true_error(unreachable, kInfinity), 0);
  EXPECT_EQ(true_error(unknown("column_generation", 0, 4), kInfinity), kInfinity);
}

TEST(TrueError, IsThatOfTheClaim) {
  EXPECT_EQ(true_error(with_status(unknown("column_generation", 0, 7), DistanceStatus::contains_origin), 4),
            1);
  EXPECT_TRUE(
      std::isnan(true_error(with_status(unknown("column_generation", 0, 7), DistanceStatus::time_limit), 4)));
  EXPECT_TRUE(std::isnan(true_error(unknown("column_generation", 0, 7), kNaN)));
}

}  // namespace
}  // namespace raygauge::test_truth
