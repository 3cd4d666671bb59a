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
