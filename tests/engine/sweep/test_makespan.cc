// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/makespan.h"

#include <gtest/gtest.h>

#include <vector>

namespace raygauge {
namespace {

/// Cells n·N = 40, 30, 20, 10 in the order of the grid 10, 20, 30, 40; their times are equal to that.
Experiment four_cells() {
  Experiment experiment;
  experiment.n = {1};
  experiment.N = {10, 20, 30, 40};
  experiment.tolerance = {1e-6};
  experiment.generators = {GeneratorSpec{}};
  experiment.generators.front().name = "example2";
  experiment.repetitions = 10;
  experiment.warmup = 0;
  experiment.shuffle = false;
  return experiment;
}

const std::vector<double> kSeconds = {10, 20, 30, 40};

TEST(Makespan, OneWorkerTakesAllTheWork) {
  const Makespan makespan = simulate_ranks(four_cells(), kSeconds, 1, 0);
  EXPECT_DOUBLE_EQ(makespan.seconds, 100);
  EXPECT_DOUBLE_EQ(makespan.efficiency, 1);
  EXPECT_EQ(makespan.pieces, 4u);
}

TEST(Makespan, TwoWorkersTakeTheLongestFirst) {
  const Makespan makespan = simulate_ranks(four_cells(), kSeconds, 2, 0);  // 40 + 10, 30 + 20
  EXPECT_DOUBLE_EQ(makespan.seconds, 50);
  EXPECT_DOUBLE_EQ(makespan.efficiency, 1);
}

TEST(Makespan, ACellDearerThanAFairShareIsSplit) {
  // A share is 25: the cells of 40 and 30 are split in 4 and 3 pieces of 4 … 3 repetitions.
  const Makespan makespan = simulate_ranks(four_cells(), kSeconds, 4, 0);
  EXPECT_EQ(makespan.pieces, 4u + 3u + 1u + 1u);
  EXPECT_LT(makespan.seconds, 40);
  EXPECT_GE(makespan.seconds, 25);
  Experiment adaptive = four_cells();
  adaptive.stop_when_within = 0.1;
  EXPECT_DOUBLE_EQ(simulate_ranks(adaptive, kSeconds, 4, 0).seconds, 40);
}

TEST(Makespan, ASlowCounterHoldsBackManyWorkers) {
  const Makespan makespan = simulate_ranks(four_cells(), kSeconds, 1000, 5);
  EXPECT_EQ(makespan.pieces, 40u);  // one for each repetition
  EXPECT_DOUBLE_EQ(makespan.counter_seconds, 200);
  EXPECT_GE(makespan.seconds, 200);
}

TEST(Makespan, ShardsAreDealtOutBeforehand) {
  Experiment adaptive = four_cells();
  adaptive.stop_when_within = 0.1;  // whole cells: 40, 20 and 30, 10
  EXPECT_DOUBLE_EQ(simulate_shards(adaptive, kSeconds, 2).seconds, 60);
  EXPECT_DOUBLE_EQ(simulate_ranks(adaptive, kSeconds, 2, 0).seconds, 50);
}

}  // namespace
}  // namespace raygauge
