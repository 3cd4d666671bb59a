// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/performance_profile/performance_profile.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"
#include "tests/analysis/records.h"

namespace raygauge::test_performance_profile {
namespace {

using raygauge::testing::add_records;

std::vector<Record> four_instances() {
  std::vector<Record> records;
  add_records(records, "column_generation", 3, 200, {1, 2, 3, 8});
  add_records(records, "glpk_dual", 3, 200, {4, 2, 30, 4});
  return records;
}

TEST(PerformanceProfile, IsTheShareSolvedWithinAMultipleOfTheFastest) {
  const std::vector<ProfileCurve> curves = performance_profiles(four_instances());
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].method, "column_generation");
  EXPECT_EQ(curves[0].ratios, (std::vector<double>{1, 1, 1, 2}));
  EXPECT_EQ(curves[1].ratios, (std::vector<double>{1, 1, 4, 10}));
  EXPECT_DOUBLE_EQ(curves[0].rho(1), 0.75);
  EXPECT_DOUBLE_EQ(curves[0].rho(2), 1);
  EXPECT_DOUBLE_EQ(curves[1].rho(3.9), 0.5);
  EXPECT_DOUBLE_EQ(curves[1].rho(10), 1);
}

TEST(PerformanceProfile, CountsLimitsDisagreementsAndMissingSolvesAsUnsolved) {
  std::vector<Record> records = four_instances();
  records[1].status = DistanceStatus::time_limit;
  records[2].agrees = false;
  records.erase(records.begin());  // column_generation on instance 0
  const std::vector<ProfileCurve> curves = performance_profiles(records);
  EXPECT_EQ(curves[0].instances, 4U);
  EXPECT_DOUBLE_EQ(curves[0].rho(1e9), 0.25);
  EXPECT_DOUBLE_EQ(curves[1].rho(1), 1);
}

TEST(PerformanceProfile, KeepsInstancesThatNobodySolvesInTheDenominator) {
  std::vector<Record> records = four_instances();
  for (Record& record : records)
    if (record.repetition == 3) record.status = DistanceStatus::iteration_limit;
  EXPECT_DOUBLE_EQ(performance_profiles(records)[0].rho(1e9), 0.75);
  EXPECT_THROW(performance_profiles({}), EmptySetError);
}

}  // namespace
}  // namespace raygauge::test_performance_profile
