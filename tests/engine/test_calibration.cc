// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/calibration.h"

#include <gtest/gtest.h>

#include "tests/engine/fake_components.h"

namespace raygauge::test_calibration {
namespace {

class Calibrations : public ::testing::Test {
 protected:
  Calibration run(const Experiment& experiment, int threads) {
    const SweepPlan plan(experiment, generators_, methods_);
    return calibrate(plan, plan.cells(), threads, {});
  }

  testing::CallLog log_;
  GeneratorRegistry generators_ = testing::fake_generators();
  MethodRegistry methods_ = testing::fake_methods(log_);
};

TEST_F(Calibrations, SolvesThatOnlyWaitTakeAtLeastTheirTime) {
  Experiment experiment = testing::small_experiment();
  experiment.methods = {{"ray", "short", {{"busy_seconds", 5e-3}}},
                        {"ray", "long", {{"busy_seconds", 2e-2}}}};
  const Calibration calibration = run(experiment, 2);
  EXPECT_EQ(calibration.threads, 2);
  ASSERT_EQ(calibration.entries.size(), 2u);
  EXPECT_EQ(calibration.entries[0].method, "short");
  EXPECT_EQ(calibration.entries[1].method, "long");
  for (const Calibration::Entry& entry : calibration.entries) {
    // How much longer is the scheduler's affair, and on a busy machine anything.
    EXPECT_GT(entry.inflation, 0);
  }
  EXPECT_GE(calibration.entries[0].parallel_seconds, 5e-3);
  EXPECT_GE(calibration.entries[1].parallel_seconds, 2e-2);
  EXPECT_GE(calibration.entries[0].serial_seconds, 5e-3);
  EXPECT_GE(calibration.entries[1].serial_seconds, 2e-2);
}

TEST_F(Calibrations, AskedToStopItIsEmpty) {
  const Experiment experiment = testing::small_experiment();
  const SweepPlan plan(experiment, generators_, methods_);
  std::atomic<int> samples{0};
  SweepHooks hooks;
  hooks.stop = [&] { return samples >= 3; };
  hooks.time = [&](SolveMethod& method, const SolveRequest& request, double) {
    ++samples;
    method.solve(request);
    return TimedSolve{1, 1};
  };
  const Calibration calibration = calibrate(plan, plan.cells(), 2, {}, hooks);
  EXPECT_TRUE(calibration.entries.empty());
  EXPECT_EQ(samples, 3);
}

TEST_F(Calibrations, ThreadsThatTakeTwiceTheTimeInflateByTwo) {
  Experiment experiment = testing::small_experiment();
  const SweepPlan plan(experiment, generators_, methods_);
  // The first samples, 3 instances by 2 methods, are those of the thread alone.
  std::atomic<int> samples{0};
  SweepHooks hooks;
  hooks.time = [&](SolveMethod& method, const SolveRequest& request, double) {
    method.solve(request);
    return TimedSolve{++samples <= 6 ? 0.5 : 1.0, 1};
  };
  const Calibration calibration = calibrate(plan, plan.cells(), 2, {}, hooks);
  ASSERT_EQ(calibration.entries.size(), 2u);
  for (const Calibration::Entry& entry : calibration.entries) {
    EXPECT_EQ(entry.serial_seconds, 0.5);
    EXPECT_EQ(entry.parallel_seconds, 1);
    EXPECT_EQ(entry.inflation, 2);
  }
}

TEST(CalibrationEntry, InflationIsTheMedianOfTheRatiosNotTheRatioOfTheMedians) {
  const std::vector<double> alone = {1, 10, 100};
  const std::vector<double> one = {2, 11, 110};     // ratios 2, 1.1, 1.1
  const std::vector<double> other = {3, 13, 1000};  // ratios 3, 1.3, 10
  const Calibration::Entry entry = calibration_entry("ours", alone, {one, other});
  EXPECT_EQ(entry.method, "ours");
  EXPECT_EQ(entry.serial_seconds, 10);
  EXPECT_EQ(entry.parallel_seconds, 12) << "the mean of 11 and 13";
  EXPECT_DOUBLE_EQ(entry.inflation, (1.3 + 2) / 2);
}

TEST(CalibrationEntry, IsOneWhereCompanyCostsNothing) {
  const std::vector<double> times = {3e-6, 1e-6, 2e-6};
  const Calibration::Entry entry = calibration_entry("ours", times, {times, times});
  EXPECT_EQ(entry.serial_seconds, 2e-6);
  EXPECT_EQ(entry.parallel_seconds, 2e-6);
  EXPECT_EQ(entry.inflation, 1);
}

TEST(CalibrationEntry, LeavesOutAThreadThatWasNotGranted) {
  const std::vector<double> alone = {1, 2, 4};
  const std::vector<double> together = {1.5, 3, 6};
  EXPECT_EQ(calibration_entry("ours", alone, {together, {}}).inflation, 1.5);
}

TEST_F(Calibrations, AFailureWhilePreparingIsRethrown) {
  Experiment experiment = testing::small_experiment();
  experiment.n = {91};
  EXPECT_THROW(run(experiment, 2), InvalidParameterError);
}

TEST_F(Calibrations, AFailureWhileMeasuringIsRethrown) {
  Experiment experiment = testing::small_experiment();
  experiment.methods = {{"ray", "", {{"throw_at", std::int64_t{3}}}}};
  EXPECT_THROW(run(experiment, 2), Error);
}

}  // namespace
}  // namespace raygauge::test_calibration
