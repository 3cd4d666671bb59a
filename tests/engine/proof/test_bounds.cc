// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/proof/bounds.h"

#include <gtest/gtest.h>

#include <limits>

namespace raygauge::test_bounds {
namespace {

using Limits = std::numeric_limits<double>;

TEST(Bounds, OnlyGetBetter) {
  Bounds bounds;
  EXPECT_EQ(bounds.lower(), 0);
  EXPECT_EQ(bounds.upper(), Limits::infinity());
  EXPECT_TRUE(bounds.raise_lower(1));
  EXPECT_TRUE(bounds.reduce_upper(3));
  EXPECT_FALSE(bounds.raise_lower(0.5));
  EXPECT_FALSE(bounds.raise_lower(1));
  EXPECT_FALSE(bounds.reduce_upper(4));
  EXPECT_EQ(bounds.lower(), 1);
  EXPECT_EQ(bounds.upper(), 3);
}

TEST(Bounds, AreNotMovedByWhatIsNoNumber) {
  Bounds bounds(Limits::quiet_NaN(), Limits::quiet_NaN());
  EXPECT_EQ(bounds.lower(), 0);
  EXPECT_EQ(bounds.upper(), Limits::infinity());
  bounds = {1, 2};
  EXPECT_FALSE(bounds.raise_lower(Limits::quiet_NaN()));
  EXPECT_FALSE(bounds.reduce_upper(Limits::quiet_NaN()));
  EXPECT_EQ(bounds.gap(), 1);
}

TEST(Bounds, CloseToARelativeTolerance) {
  EXPECT_TRUE(Bounds(0.75, 1).close(0.25));
  EXPECT_FALSE(Bounds(0.75, 1).close(0.2));
  EXPECT_TRUE(Bounds(0, 0).close(0.25));
  EXPECT_FALSE(Bounds().close(0.25));
  EXPECT_FALSE(Bounds(Limits::infinity(), Limits::infinity()).close(0.25));
}

TEST(Bounds, ThatContradictEachOtherDecideNothing) {
  EXPECT_FALSE(Bounds(2, 1).agree());
  EXPECT_FALSE(Bounds(2, 1).close(0.5));
}

TEST(Bounds, ReachAGoalOnOneSideOfItsThreshold) {
  EXPECT_TRUE(Bounds(1.5, 9).reach({1e-6, 1}));
  EXPECT_TRUE(Bounds(0, 0.5).reach({1e-6, 1}));
  EXPECT_FALSE(Bounds(0.5, 1.5).reach({1e-6, 1}));
  EXPECT_FALSE(Bounds(1.5, 9).reach({1e-6}));
}

TEST(Bounds, AreScaledOutward) {
  const Bounds bounds = Bounds(3, 5).scaled(2);
  EXPECT_EQ(bounds.lower(), 12);
  EXPECT_EQ(bounds.upper(), 20);
  EXPECT_EQ(Bounds(1, 1).scaled(2000).lower(), Limits::max());
  EXPECT_EQ(Bounds(1, 1).scaled(2000).upper(), Limits::infinity());
}

}  // namespace
}  // namespace raygauge::test_bounds
