// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analysis/studies/accuracy/accuracy_tables.h"
#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_accuracy {
namespace {

using testing::record;

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// A solve at tolerance ε that is off by `error` of a distance of 2, proven to a width of `gap`.
Record solve(const std::string& method, double tolerance, double error, double gap, double microseconds) {
  static int repetition = 0;
  Record result = record(method, 3, 1, ++repetition, microseconds / 1e3);
  result.tolerance = tolerance;
  result.upper = result.distance = 2 + error;
  result.lower = result.upper - gap;
  return result;
}

std::vector<AccuracyCurve> curves_of(const std::vector<Record>& records) {
  std::vector<const Record*> all;
  for (const Record& record : records) all.push_back(&record);
  return accuracy_curves(all, Truth(records));
}

TEST(Accuracy, AveragesOverTheSolvesOfEachTolerance) {
  std::vector<Record> records = {solve("column_generation", 1e-2, 0.25, 0.5, 2),
                                 solve("column_generation", 1e-2, 0.75, 1, 4),
                                 solve("column_generation", 1e-4, 0, 0, 10)};
  records[0].counters.outer_iterations = 1;
  records[1].counters.outer_iterations = 2;
  records[0].counters.ray_iterations = records[1].counters.ray_iterations = 7;
  records[0].counters.support_queries = records[1].counters.support_queries = 12;
  const std::vector<AccuracyCurve> curves = curves_of(records);
  ASSERT_EQ(curves.size(), 1U);
  ASSERT_EQ(curves[0].points.size(), 2U);
  const AccuracyPoint& loose = curves[0].points[0];
  EXPECT_EQ(loose.tolerance, 1e-2);
  EXPECT_EQ(loose.solves, 2U);
  EXPECT_EQ(loose.mean_error, 0.5);
  EXPECT_EQ(loose.mean_relative_error, 0.25);
  EXPECT_EQ(loose.largest_relative_error, 0.375);
  EXPECT_DOUBLE_EQ(loose.mean_relative_gap, (0.5 / 2.25 + 1 / 2.75) / 2);
  EXPECT_DOUBLE_EQ(loose.mean_seconds, 3e-6);
  EXPECT_EQ(loose.K, 1.5);
  EXPECT_EQ(loose.N_rs, 7);
  EXPECT_EQ(loose.supports, 6);
  EXPECT_EQ(loose.wrong, 2U) << "off by more than 10 ε";
  EXPECT_EQ(loose.beyond_gap, 0U);
}

TEST(Accuracy, CountsErrorsBeyondTheGapAndSolvesWithoutBounds) {
  std::vector<Record> records = {solve("column_generation", 1e-2, 0.5, 0.25, 1),
                                 solve("nlopt_slsqp", 1e-2, 0.5, 0, 1)};
  records[1].lower = records[1].upper = kMissing;
  const std::vector<AccuracyCurve> curves = curves_of(records);
  EXPECT_EQ(curves[0].points[0].beyond_gap, 1U);
  EXPECT_EQ(curves[0].points[0].bounded, 1U);
  EXPECT_EQ(curves[1].points[0].beyond_gap, 0U);
  EXPECT_EQ(curves[1].points[0].bounded, 0U);
  EXPECT_TRUE(std::isinf(curves[1].points[0].mean_relative_gap));
}

TEST(Accuracy, KeepsWhatAFailedSolveLeft) {
  std::vector<Record> records = {solve("nlopt_slsqp", 1e-2, 0.5, 0, 1), solve("nlopt_slsqp", 1e-2, 0, 0, 3)};
  records[0].status = DistanceStatus::precision_limit;
  records[1].status = DistanceStatus::precision_limit;
  records[1].distance = kMissing;
  const AccuracyPoint point = curves_of(records)[0].points[0];
  EXPECT_EQ(point.failures, 2U);
  EXPECT_EQ(point.mean_error, 0.5) << "of the one that left a number";
  EXPECT_TRUE(std::isinf(point.largest_relative_error));
  EXPECT_DOUBLE_EQ(point.mean_seconds, 2e-6) << "time spent is time spent";
}

TEST(Accuracy, IsThatOfTheAnswersWhereSomeSolvesFailed) {
  std::vector<Record> records = {solve("nlopt_slsqp", 1e-2, 0.5, 0, 1),
                                 solve("nlopt_slsqp", 1e-2, 0.25, 0, 3)};
  records[0].status = DistanceStatus::iteration_limit;
  const AccuracyPoint point = curves_of(records)[0].points[0];
  EXPECT_EQ(point.failures, 1U);
  EXPECT_EQ(point.mean_error, 0.25);
  EXPECT_EQ(point.mean_relative_error, 0.125);
  EXPECT_EQ(point.largest_relative_error, 0.25) << "of all solves";
}

TEST(Accuracy, TakesTheTruthFromTheExactMethodWhereTheGeneratorHasNone) {
  Record approximate = solve("column_generation", 1e-2, 0.5, 0.5, 1);
  Record exact = approximate;
  exact.method = "exact";
  exact.role = Role::oracle;
  exact.distance = 2.25;
  approximate.exact_distance = exact.exact_distance = kMissing;
  EXPECT_EQ(curves_of({approximate, exact})[0].points[0].mean_error, 0.25);
  EXPECT_TRUE(std::isnan(curves_of({approximate})[0].points[0].mean_error));
}

TEST(Accuracy, AllowsTheTruthItsOwnRounding) {
  Record solved = solve("column_generation", 1e-12, 0, 0, 1);
  const auto beyond = [&](double distance, const char* generator) {
    solved.generator = generator;
    solved = testing::with_facts(solved);
    solved.lower = solved.distance = solved.upper = distance;
    return curves_of({solved})[0].points[0].beyond_gap;
  };
  EXPECT_EQ(beyond(std::nextafter(2, 3), "example1"), 0U);
  EXPECT_EQ(beyond(std::nextafter(2, 3), "hard_needle"), 1U) << "whose truth is exact";
  EXPECT_EQ(beyond(2 + 0x1p-43, "example1"), 1U);
}

TEST(Accuracy, FindsWhereAMethodStopsGettingBetter) {
  const std::vector<Record> records = {
      solve("column_generation", 1e-2, 1e-3, 1e-3, 10), solve("column_generation", 1e-4, 1e-5, 1e-5, 14),
      solve("column_generation", 1e-6, 2e-9, 1e-9, 18), solve("column_generation", 1e-8, 1e-9, 1e-9, 30)};
  const AccuracyFloor floor = accuracy_floor(curves_of(records)[0]);
  EXPECT_EQ(floor.reached.tolerance, 1e-6);
  EXPECT_FALSE(floor.still_improving);
  EXPECT_NEAR(floor.seconds_a_digit, 2e-6, 1e-18);
  EXPECT_EQ(floor.certified, 1e-8);
}

TEST(Accuracy, SaysThatTheTightestToleranceStillHelped) {
  const std::vector<Record> records = {solve("column_generation", 1e-2, 1e-2, 1e-1, 1),
                                       solve("column_generation", 1e-4, 1e-4, 1e-1, 2)};
  const AccuracyFloor floor = accuracy_floor(curves_of(records)[0]);
  EXPECT_TRUE(floor.still_improving);
  EXPECT_TRUE(std::isnan(floor.certified)) << "no gap is within its tolerance";
}

TEST(AccuracyTables, LeaveOutTheMethodThatTheTruthIsFrom) {
  const std::vector<Record> records = {solve("exact", 1e-2, 0, 0, 1),
                                       solve("column_generation", 1e-2, 1e-3, 1e-3, 2)};
  const std::vector<AccuracyGroup> groups = accuracy_groups(records);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].name, "example2, n = 3, N = 1");
  ASSERT_EQ(groups[0].curves.size(), 1U);
  EXPECT_EQ(groups[0].curves[0].method, "column_generation");
  EXPECT_THROW(accuracy_groups(records, Filter("n==4")), EmptySetError);
}

TEST(AccuracyTables, AverageOverNoParameterOfTheGenerator) {
  std::vector<Record> records = {solve("column_generation", 1e-2, 1e-3, 1e-3, 1),
                                 solve("column_generation", 1e-2, 1e-3, 1e-3, 3)};
  records[0].generator_parameters = "clusters=16 separation=1.2";
  records[1].generator_parameters = "clusters=16 separation=3";
  const std::vector<AccuracyGroup> groups = accuracy_groups(records);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].name, "example2, separation=1.2, n = 3, N = 1");
  EXPECT_EQ(groups[1].name, "example2, separation=3, n = 3, N = 1");
  EXPECT_EQ(groups[1].curves[0].points[0].solves, 1U);
}

TEST(AccuracyTables, SayThatOnlyTheExactMethodPassesAFilter) {
  const std::vector<Record> records = {solve("column_generation", 1e-6, 0, 1e-9, 1),
                                       solve("exact", 1e-6, 0, 0, 1)};
  EXPECT_EQ(testing::message_of<EmptySetError>([&] { accuracy_groups(records, Filter("method==exact")); }),
            "accuracy of the method exact alone: it is where truths come from, and is not judged");
}

TEST(AccuracyTables, PriceTheNextDigit) {
  const std::vector<Record> records = {solve("column_generation", 1e-2, 1e-3, 1e-3, 2),
                                       solve("column_generation", 1e-4, 1e-5, 1e-5, 5)};
  const std::string text = render(accuracy_tables(accuracy_groups(records)).front());
  EXPECT_NE(text.find("column_generation  0.01  0.00050"), std::string::npos) << text;
  EXPECT_NE(text.find(" 1.5 "), std::string::npos) << text;
}

}  // namespace
}  // namespace raygauge::test_accuracy
