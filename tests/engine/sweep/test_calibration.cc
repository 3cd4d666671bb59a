// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/calibration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "engine/sweep/schedule.h"
#include "tests/engine/fake_components.h"

namespace raygauge::test_calibration {
namespace {

class Calibrations : public ::testing::Test {
 protected:
  LoneSolves run(const Experiment& experiment, const SweepHooks& hooks = {}) {
    const SweepPlan plan(experiment, generators_, methods_);
    return solve_alone(plan, plan.cells(), 2, {}, hooks);
  }

  testing::CallLog log_;
  GeneratorRegistry generators_ = testing::fake_generators();
  MethodRegistry methods_ = testing::fake_methods(log_);
};

/// What two methods took in each repetition of cell 5, on so many threads.
std::vector<Record> records_of(const std::vector<double>& ours, const std::vector<double>& theirs,
                               int concurrency) {
  std::vector<Record> records;
  for (std::size_t r = 0; r < ours.size(); ++r) {
    for (const auto& [method, seconds] : {std::pair("ours", ours[r]), std::pair("theirs", theirs[r])}) {
      Record& record = records.emplace_back();
      record.cell = 5;
      record.method = method;
      record.repetition = static_cast<int>(r);
      record.seconds = seconds;
      record.concurrency = concurrency;
    }
  }
  return records;
}

LoneSolves alone(const std::vector<double>& ours, const std::vector<double>& theirs) {
  return {{}, records_of(ours, theirs, 1)};
}

TEST_F(Calibrations, TheFirstInstancesOfACellOfMedianCostAreSolvedAlone) {
  const Experiment experiment = testing::small_experiment();
  const LoneSolves solves = run(experiment);
  const SweepPlan plan(experiment, generators_, methods_);
  std::vector<double> costs;
  for (const Cell& cell : plan.cells()) costs.push_back(expected_cost(cell));
  std::sort(costs.begin(), costs.end());
  EXPECT_EQ(expected_cost(solves.cell), costs[(costs.size() - 1) / 2]);
  ASSERT_EQ(solves.records.size(), 4U * 2) << "a cell has 4 instances, fewer than an interval takes";
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(solves.records[i].cell, solves.cell.index);
    EXPECT_EQ(solves.records[i].repetition, static_cast<int>(i / 2));
    EXPECT_EQ(solves.records[i].method, i % 2 == 0 ? "first" : "second");
    EXPECT_EQ(solves.records[i].concurrency, 1);
  }
}

TEST_F(Calibrations, MoreInstancesWhereTheSweepIsLongButNoMoreThanAMedianNeeds) {
  Experiment experiment = testing::small_experiment();
  experiment.repetitions = 270;  // 12 cells · 270 / 2 threads · 0.005 = 8.1
  EXPECT_EQ(run(experiment).records.size(), 8U * 2);
  experiment.repetitions = 10000;
  EXPECT_EQ(run(experiment).records.size(), 15U * 2);
}

TEST_F(Calibrations, NoMoreInstancesThanACellThatEndsEarlyIsSureToHave) {
  Experiment experiment = testing::small_experiment();
  experiment.repetitions = 10000;
  experiment.stop_when_within = 0.1;
  experiment.min_repetitions = 7;
  EXPECT_EQ(run(experiment).records.size(), 7U * 2);
}

TEST_F(Calibrations, AskedToStopItIsEmpty) {
  std::atomic<int> samples{0};
  SweepHooks hooks;
  hooks.stop = [&] { return samples >= 3; };
  hooks.time = [&](SolveMethod& method, const SolveRequest& request, double) {
    ++samples;
    method.solve(request);
    return TimedSolve{1, 1};
  };
  const LoneSolves solves = run(testing::small_experiment(), hooks);
  EXPECT_TRUE(solves.records.empty());
  EXPECT_EQ(samples, 3);
  EXPECT_TRUE(calibration_of(solves, records_of({1}, {1}, 2)).entries.empty());
}

TEST_F(Calibrations, AFailureWhilePreparingIsRethrown) {
  Experiment experiment = testing::small_experiment();
  experiment.n = {91};
  EXPECT_THROW(run(experiment), InvalidParameterError);
}

TEST_F(Calibrations, AFailureWhileMeasuringIsRethrown) {
  Experiment experiment = testing::small_experiment();
  experiment.methods = {{"ray", "", {{"throw_at", std::int64_t{3}}}}};
  EXPECT_THROW(run(experiment), Error);
}

TEST(CalibrationOf, InflationIsTheMedianOfTheRatiosNotTheRatioOfTheMedians) {
  const LoneSolves lone = alone({1, 10, 100}, {5, 5, 5});
  // Ratios 3, 1.1 and 10; more repetitions than were solved alone are not compared.
  const Calibration calibration = calibration_of(lone, records_of({3, 11, 1000, 7}, {5, 5, 5, 9}, 2));
  EXPECT_EQ(calibration.threads, 2);
  ASSERT_EQ(calibration.entries.size(), 2U);
  EXPECT_EQ(calibration.entries[0].method, "ours");
  EXPECT_EQ(calibration.entries[0].serial_seconds, 10);
  EXPECT_EQ(calibration.entries[0].parallel_seconds, 11);
  EXPECT_EQ(calibration.entries[0].slowdown, 3);
  EXPECT_EQ(calibration.entries[1].method, "theirs");
  EXPECT_EQ(calibration.entries[1].slowdown, 1);
}

TEST(CalibrationOf, WhatCannotBeToldFromNoSlowdownIsNoise) {
  const auto slowdown_of = [](const std::vector<double>& together) {
    const std::vector<double> ones(together.size(), 1.0);
    return calibration_of(alone(ones, ones), records_of(together, ones, 2)).entries.front();
  };
  EXPECT_TRUE(slowdown_of({1.5, 1.5, 1.5}).is_noise()) << "three values have no interval";
  EXPECT_TRUE(slowdown_of({0.9, 1.1, 1.2, 1.3, 1.1, 1.2}).is_noise());
  const Calibration::Entry slower = slowdown_of({1.2, 1.1, 1.2, 1.3, 1.1, 1.4});
  EXPECT_FALSE(slower.is_noise());
  EXPECT_EQ(slower.slowdown_lower, 1.1);
  EXPECT_EQ(slower.slowdown_upper, 1.4);
  EXPECT_FALSE(Calibration::Entry().is_noise()) << "nothing was measured";
}

TEST(CalibrationOf, IsEmptyWhereTheRuntimeGrantedOneThread) {
  EXPECT_TRUE(calibration_of(alone({1, 2}, {1, 2}), records_of({1, 2}, {1, 2}, 1)).entries.empty());
}

}  // namespace
}  // namespace raygauge::test_calibration
