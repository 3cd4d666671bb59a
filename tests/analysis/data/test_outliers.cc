// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/data/outliers.h"

#include <gtest/gtest.h>

#include <limits>

#include "raygauge/exceptions.h"

namespace raygauge::test_outliers {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Outliers, LieBeyondTukeysFences) {
  // Quartiles 2 and 4 (type 7): fences 2 - 3 and 4 + 3.
  const std::vector<double> values = {1, 2, 3, 4, 100};
  const Interval fences = tukey_fences(values);
  EXPECT_DOUBLE_EQ(fences.lower, -1);
  EXPECT_DOUBLE_EQ(fences.upper, 7);
  EXPECT_EQ(outlier_count(values), 1U);
  EXPECT_EQ(outlier_count(values, 48), 0U);
}

TEST(Outliers, DoNotIncludeWhatLiesOnAFence) { EXPECT_EQ(outlier_count({1, 2, 3, 4, 7}), 0U); }

TEST(Outliers, LeaveUnsolvedTimesToOthers) {
  EXPECT_EQ(outlier_count({1, 2, 3, 4, 5, 6, 7, 8, kInfinity}), 0U);
  EXPECT_EQ(outlier_count({1, kInfinity, kInfinity}), 0U);
}

TEST(Outliers, RefuseNothingAndANegativeFactor) {
  EXPECT_THROW(tukey_fences({}), EmptySetError);
  EXPECT_THROW(tukey_fences({1}, -1), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_outliers
