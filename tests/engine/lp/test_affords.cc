// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/affords.h"

#include <gtest/gtest.h>

namespace raygauge {
namespace {

constexpr double kHours = 1e18;  // operations

TEST(Affords, WithoutALimitThereIsTimeForAnything) {
  const Stopwatch watch;
  StepTimes steps;
  EXPECT_TRUE(affords(watch, kHours));
  EXPECT_TRUE(steps.affords_next(watch, kHours));
}

TEST(Affords, FirstStepIsReckonedByItsOperations) {
  Stopwatch watch;
  watch.start(3600);
  StepTimes steps;
  EXPECT_FALSE(steps.affords_next(watch, kHours));
}

TEST(Affords, LaterStepsAreReckonedByThoseBefore) {
  Stopwatch watch;
  watch.start(3600);
  StepTimes steps;
  EXPECT_TRUE(steps.affords_next(watch, 1));
  EXPECT_TRUE(steps.affords_next(watch, kHours)) << "a step took next to nothing, 3600 s are left";
}

TEST(Affords, StepThatTookHalfOfTheLimitIsNotRepeated) {
  Stopwatch watch;
  watch.start(0.02);
  StepTimes steps;
  EXPECT_TRUE(steps.affords_next(watch, 1));
  while (watch.remaining() > 0.009) {
  }
  EXPECT_FALSE(steps.affords_next(watch, 1));
}

}  // namespace
}  // namespace raygauge
