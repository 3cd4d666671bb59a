// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/cell_clock.h"

#include <gtest/gtest.h>

namespace raygauge::test_cell_clock {
namespace {

ScenePlan plan_of(const std::vector<SceneCellKind>& kinds) {
  ScenePlan plan;
  for (const SceneCellKind kind : kinds) plan.cells.push_back({kind});
  return plan;
}

TEST(CellClock, CellsAheadTakeAsLongAsThoseOfTheirKind) {
  const auto quick = SceneCellKind::instants, slow = SceneCellKind::continuous;
  const ScenePlan plan = plan_of({quick, slow, quick, quick, slow, slow});
  const std::vector<std::uint64_t> cells = {0, 1, 2, 3, 4, 5};
  CellClock clock(plan, cells, 1);
  EXPECT_EQ(clock.seconds_left(0), 0);
  clock.begin(0, 0);
  clock.end(0, 0.1);
  EXPECT_NEAR(clock.seconds_left(0.1), 5 * 0.1, 1e-12);  // nothing is known of slow ones
  clock.begin(1, 0.1);
  clock.end(1, 4.1);
  EXPECT_NEAR(clock.seconds_left(4.1), 2 * 0.1 + 2 * 4, 1e-12);
  clock.begin(2, 4.1);
  clock.begin(3, 4.1);
  clock.end(3, 4.2);
  clock.end(2, 4.2);
  EXPECT_NEAR(clock.seconds_left(4.2), 2 * 4, 1e-12);
}

// The last of many quick cells takes long: its end is not promised sooner than in the time that it has taken.
TEST(CellClock, ACellThatTakesLongerIsExpectedToTakeAsLongAgain) {
  const ScenePlan plan = plan_of(std::vector<SceneCellKind>(11, SceneCellKind::continuous));
  const std::vector<std::uint64_t> cells = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  CellClock clock(plan, cells, 2);
  for (std::size_t i = 0; i < 10; ++i) {
    clock.begin(i, 0.2 * static_cast<double>(i));
    clock.end(i, 0.2 * static_cast<double>(i + 1));
  }
  clock.begin(10, 2);
  EXPECT_NEAR(clock.seconds_left(2), 0.2, 1e-12);
  EXPECT_NEAR(clock.seconds_left(2.1), 0.1, 1e-12);
  EXPECT_NEAR(clock.seconds_left(6), 4, 1e-12);
}

// Ranks of a job share the cells: what others took is not ahead.
TEST(CellClock, CellsThatOthersTakeAreNotAhead) {
  const ScenePlan plan = plan_of(std::vector<SceneCellKind>(10, SceneCellKind::instants));
  const std::vector<std::uint64_t> cells = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  CellClock clock(plan, cells, 1);
  clock.begin(0, 0);
  clock.end(0, 1);
  clock.begin(7, 1);
  clock.end(7, 2);
  EXPECT_NEAR(clock.seconds_left(2), 2, 1e-12);
}

}  // namespace
}  // namespace raygauge::test_cell_clock
