// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep/method.h"

#include <gtest/gtest.h>

#include "tests/engine/fake_components.h"

namespace raygauge::test_timed_solve {
namespace {

class TimedSolves : public ::testing::Test {
 protected:
  TimedSolve time(double busy_seconds, double min_seconds) {
    const auto method = testing::fake_methods(log_).make("ray", {{"busy_seconds", busy_seconds}});
    const Instance instance = testing::RayGenerator(0).generate({});
    method->load(instance);
    return time_solve(*method, {}, min_seconds);
  }

  testing::CallLog log_;
};

TEST_F(TimedSolves, ALongSolveIsSampledOnce) {
  const TimedSolve timed = time(2e-3, 1e-3);
  EXPECT_EQ(timed.inner_repetitions, 1);
  EXPECT_EQ(log_.solves, 1);
  EXPECT_GE(timed.seconds, 2e-3);
}

TEST_F(TimedSolves, ShortSolvesAreRepeatedUntilTheSampleIsLongEnough) {
  const TimedSolve timed = time(0, 1e-3);
  EXPECT_GT(timed.inner_repetitions, 1);
  EXPECT_GE(timed.seconds * timed.inner_repetitions, 1e-3 * (1 - 1e-12));
  EXPECT_LT(timed.seconds, 1e-3);
}

TEST_F(TimedSolves, TheDecidingSolveIsNotPartOfARepeatedSample) {
  const TimedSolve timed = time(0, 1e-3);
  EXPECT_EQ(log_.solves, timed.inner_repetitions + 1);
}

}  // namespace
}  // namespace raygauge::test_timed_solve
