// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/effects.h"

#include <gtest/gtest.h>

namespace raygauge::test_effects {
namespace {

SceneRecord clearance(SceneStatus status, double lower) {
  SceneRecord record;
  record.kind = SceneEffects::clearance;
  record.status = status;
  record.lower = lower;
  record.upper = 0.25;
  record.time = 2;
  return record;
}

std::string text_of(const SceneRecord& record) { return entry_of(record.kind).event(record, "").text; }

TEST(SceneEvents, PromiseNoDistanceWhereNoneIsProven) {
  EXPECT_EQ(text_of(clearance(SceneStatus::separated, 0.2)), "never closer than 0.2; 0.25 at 2 s");
  EXPECT_EQ(text_of(clearance(SceneStatus::undecided, 0)), "meet, or nearly: undecided; 0.25 at 2 s");
  EXPECT_EQ(text_of(clearance(SceneStatus::intersecting, 0)), "they meet at 2 s");
  SceneRecord meet = clearance(SceneStatus::intersecting, 0);
  meet.time_lower = 1.5;
  EXPECT_EQ(text_of(meet), "they meet, first in [1.5, 2] s");
}

}  // namespace
}  // namespace raygauge::test_effects
