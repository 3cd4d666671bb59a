// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/integer_scaling.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

namespace raygauge::test_integer_scaling {
namespace {

TEST(IntegerScaling, MakesEveryCoordinateAnInteger) {
  Eigen::MatrixXd A(2, 2);
  A << 0.375, 1e-300, 0, 3;
  Eigen::MatrixXd Q(2, 2);
  Q << 1, -0.5, 0x1p900, 0.1;
  IntegerScaling scaling;
  scaling.compute(PointSet(A), PointSet(Q));
  const auto is_integer = [](double value, std::int64_t shift) {
    const double scaled = std::ldexp(value, static_cast<int>(shift));
    return !std::isfinite(scaled) || scaled == std::nearbyint(scaled);
  };
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 2; ++i) {
      EXPECT_TRUE(is_integer(A(k, i), scaling.shift_A(k)));
      EXPECT_TRUE(is_integer(Q(k, i), scaling.shift_Q(k)));
    }
    EXPECT_EQ(scaling.shift_A(k) - scaling.shift_Q(k), scaling.lift());
  }
}

TEST(IntegerScaling, LeavesNoFactorInSetsOfDifferentSize) {
  const Eigen::MatrixXd A = Eigen::MatrixXd::Constant(2, 1, 0x1p700);
  const Eigen::MatrixXd Q = 0x1p-700 * Eigen::MatrixXd::Identity(2, 2);
  IntegerScaling scaling;
  scaling.compute(PointSet(A), PointSet(Q));
  EXPECT_EQ(scaling.lift(), -1400);
  EXPECT_EQ(scaling.shift_A(0), -700);
}

}  // namespace
}  // namespace raygauge::test_integer_scaling
