// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/simulation/impulse_memory.h"

#include <gtest/gtest.h>

namespace raygauge::test_impulse_memory {
namespace {

// Two feet of one pair, nearer to each other than a place may move from step to step.
TEST(ImpulseMemory, of_points_that_are_near_each_other_each_begins_with_its_own_impulse) {
  constexpr double kNear = 0.1;
  std::vector<ContactUnknown> feet(2);
  NearPair pair;
  for (const auto foot : {0, 1}) {
    ContactUnknown& one = feet[static_cast<std::size_t>(foot)];
    one.a = pair.a = 3;
    one.b = pair.b = 4;
    one.at = {0.05 * foot, 0, 0};
    one.impulse = {0, 0, 1.0 + foot};
  }
  ImpulseMemory memory;
  memory.remember(feet, 1e-3);
  for (const ContactUnknown& one : feet)
    EXPECT_EQ(memory.guess(pair, {one.at + Eigen::Vector3d(0.01, 0, 0), 0}, kNear, 1e-3), one.impulse);
  EXPECT_TRUE(memory.guess(pair, {{0.2, 0, 0}, 0}, kNear, 1e-3).isZero(0));
}

}  // namespace
}  // namespace raygauge::test_impulse_memory
