// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/portable_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace raygauge::test_portable_log {
namespace {

// The documented accuracy: 4 units in the last place of the result.
constexpr double kRelativeError = 4 * std::numeric_limits<double>::epsilon();

TEST(PortableLog, AgreesWithTheStandardLibraryFromTheSmallestToTheLargestNumber) {
  for (double x = std::numeric_limits<double>::denorm_min(); std::isfinite(x); x *= 1.37) {
    EXPECT_NEAR(portable_log(x), std::log(x), kRelativeError * std::abs(std::log(x))) << x;
    if (x < 1e-300) x *= 2;  // subnormal numbers times 1.37 may round to themselves
  }
}

TEST(PortableLog, KeepsItsRelativeAccuracyNextToOne) {
  for (double delta = 0.3; delta > 1e-16; delta /= 2) {
    for (const double x : {1 + delta, 1 - delta}) {
      EXPECT_NEAR(portable_log(x), std::log(x), kRelativeError * std::abs(std::log(x))) << x;
    }
  }
  EXPECT_EQ(portable_log(1), 0);
}

}  // namespace
}  // namespace raygauge::test_portable_log
