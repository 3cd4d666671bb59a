// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/scaling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raygauge/sets/ball.h"
#include "tests/engine/point_clouds.h"

namespace raygauge::test_scaling {
namespace {

bool is_power_of_two(double x) {
  int exponent = 0;
  return x > 0 && std::frexp(x, &exponent) == 0.5;
}

TEST(Scaling, LeavesSetsOfMagnitudeOneAlone) {
  Random random(1);
  Scaling scaling;
  scaling.compute(PointSet(sphere_points(3, 50, random)), PointSet(sphere_points(3, 50, random)));
  EXPECT_TRUE(scaling.trivial_A());
  EXPECT_TRUE(scaling.trivial_Q());
  EXPECT_EQ(scaling.distance_shift(), 0);
}

TEST(Scaling, BringsFarMagnitudesNearOneByPowersOfTwo) {
  Random random(2);
  for (const int exponent_A : {-300, 0, 300}) {
    for (const int exponent_Q : {-300, 0, 300}) {
      const PointSet A(Eigen::MatrixXd(std::ldexp(1.0, exponent_A) * sphere_points(3, 50, random)));
      const PointSet Q(Eigen::MatrixXd(std::ldexp(1.0, exponent_Q) * sphere_points(3, 50, random)));
      Scaling scaling;
      scaling.compute(A, Q);
      double largest_A = 0, largest_Q = 0;
      for (int k = 0; k < 3; ++k) {
        EXPECT_TRUE(is_power_of_two(scaling.factor_A()[k]));
        EXPECT_TRUE(is_power_of_two(scaling.factor_Q()[k]));
        // One shift for all coordinates, or the scaled distance would be another.
        EXPECT_EQ(scaling.factor_Q()[k], std::ldexp(scaling.factor_A()[k], -scaling.distance_shift()));
        largest_A = std::max(largest_A, A.coordinate_magnitude()[k] * scaling.factor_A()[k]);
        largest_Q = std::max(largest_Q, Q.coordinate_magnitude()[k] * scaling.factor_Q()[k]);
      }
      for (const double largest : {largest_A, largest_Q}) {
        EXPECT_GE(largest, std::ldexp(1.0, -Scaling::kTolerated - 1));
        EXPECT_LE(largest, std::ldexp(1.0, Scaling::kTolerated + 1));
      }
    }
  }
}

TEST(Scaling, GivesAnyTwoSetsOneFactorThatBringsQToOne) {
  const Ball A(Vector::Constant(2, 3e150), 1.0);
  const Ball Q(Vector::Zero(2), 1e150);
  Scaling scaling;
  scaling.compute_common(A, Q, 3e150, 1e150);
  EXPECT_FALSE(scaling.trivial_A());
  EXPECT_EQ(scaling.distance_shift(), 0);
  EXPECT_EQ(scaling.factor_A()[0], scaling.factor_Q()[1]);
  EXPECT_TRUE(is_power_of_two(scaling.factor_A()[0]));
  EXPECT_NEAR(std::log2(1e150 * scaling.factor_Q()[0]), 0, 1);
}

TEST(Scaling, GivesASetThatIsMuchSmallerThanQAFactorOfItsOwn) {
  const Ball A(Vector::Constant(2, 3e-12), 1e-12), Q(Vector::Zero(2), 1.0);
  Scaling scaling;
  scaling.compute_common(A, Q, 4e-12, 1.0);
  EXPECT_TRUE(scaling.trivial_Q());
  EXPECT_TRUE(is_power_of_two(scaling.factor_A()[0]));
  EXPECT_NEAR(std::log2(4e-12 * scaling.factor_A()[0]), 0, 1);
  EXPECT_EQ(std::ldexp(1.0, scaling.distance_shift()), scaling.factor_A()[0]);
}

TEST(Scaling, DropsComponentsTooSmallForEitherSet) {
  EXPECT_EQ(Scaling::direction_component(0x1p300, 0x1p-250), 0);
  EXPECT_EQ(Scaling::direction_component(0x1p-10, 3.0), 3 * 0x1p-10);
}

}  // namespace
}  // namespace raygauge::test_scaling
