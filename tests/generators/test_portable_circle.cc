// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/portable_circle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "raygauge/exceptions.h"

namespace raygauge::test_portable_circle {
namespace {

TEST(PortableCircle, AgreesWithCosineAndSine) {
  for (const std::int64_t m : {1, 3, 7, 16, 1000}) {
    for (std::int64_t j = 0; j < m; ++j) {
      const long double angle = 2 * std::numbers::pi_v<long double> * j / m;
      const Eigen::Vector2d point = circle_point(j, m);
      EXPECT_NEAR(point.x(), static_cast<double>(std::cos(angle)), 0x1p-52) << j << "/" << m;
      EXPECT_NEAR(point.y(), static_cast<double>(std::sin(angle)), 0x1p-52) << j << "/" << m;
    }
  }
}

TEST(PortableCircle, OctantsAreExactMirrorImages) {
  constexpr std::int64_t m = 16;
  const Eigen::Vector2d first = circle_point(1, m);
  EXPECT_EQ(circle_point(3, m), Eigen::Vector2d(first.y(), first.x()));
  EXPECT_EQ(circle_point(5, m), Eigen::Vector2d(-first.y(), first.x()));
  EXPECT_EQ(circle_point(9, m), -first);
  EXPECT_EQ(circle_point(15, m), Eigen::Vector2d(first.x(), -first.y()));
}

TEST(PortableCircle, RefusesWhatIsNoPointOfTheCircle) {
  EXPECT_THROW(circle_point(3, 3), InvalidParameterError);
  EXPECT_THROW(circle_point(-1, 3), InvalidParameterError);
}

}  // namespace
}  // namespace raygauge::test_portable_circle
