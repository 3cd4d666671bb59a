// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sweep/experiment.h"

#include <gtest/gtest.h>

#include <functional>

namespace raygauge::test_experiment {
namespace {

Experiment grid_experiment() {
  Experiment experiment;
  experiment.n = {3, 4};
  experiment.N = {10, 20};
  experiment.tolerance = {1e-3, 1e-6};
  experiment.generators = {GeneratorSpec{{"g", "", {}}}, GeneratorSpec{{"h", "", {}}}};
  experiment.methods = {{"m", "", {}}};
  return experiment;
}

TEST(Grid, CartesianRunsThroughEveryCombinationToleranceFastest) {
  const std::vector<Cell> cells = grid_of(grid_experiment());
  ASSERT_EQ(cells.size(), 16u);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(cells[i].index, i);
    EXPECT_EQ(cells[i].generator, i / 8);
    EXPECT_EQ(cells[i].n, i / 4 % 2 == 0 ? 3 : 4);
    EXPECT_EQ(cells[i].N, i / 2 % 2 == 0 ? 10 : 20);
    EXPECT_EQ(cells[i].tolerance, i % 2 == 0 ? 1e-3 : 1e-6);
  }
}

TEST(Grid, PairedTakesSizesInStepAndStillEveryTolerance) {
  Experiment experiment = grid_experiment();
  experiment.grid = GridMode::paired;
  experiment.generators.pop_back();
  const std::vector<Cell> cells = grid_of(experiment);
  ASSERT_EQ(cells.size(), 4u);
  for (const Cell& cell : cells) EXPECT_EQ(cell.N, cell.n == 3 ? 10 : 20);
}

TEST(Grid, PairedListsOfDifferentLengthsAreRejected) {
  Experiment experiment = grid_experiment();
  experiment.grid = GridMode::paired;
  experiment.N.push_back(30);
  EXPECT_THROW(grid_of(experiment), InvalidParameterError);
}

TEST(Grid, AnEmptyAxisAndARepeatedCellAreRejected) {
  Experiment empty = grid_experiment();
  empty.N.clear();
  EXPECT_THROW(grid_of(empty), InvalidParameterError);
  Experiment repeated = grid_experiment();
  repeated.n = {3, 3};
  EXPECT_THROW(grid_of(repeated), InvalidParameterError);
}

TEST(Grid, MoreThanAMillionCellsAreRejectedBeforeTheyTakeMemory) {
  Experiment huge = grid_experiment();
  huge.n.resize(600'000);
  huge.N.resize(600'000);
  EXPECT_THROW(grid_of(huge), InvalidParameterError);
}

TEST(Validation, AcceptsTheDefaults) { EXPECT_NO_THROW(validate(grid_experiment())); }

TEST(Grid, AGeneratorMayHaveAxesOfItsOwn) {
  Experiment experiment = grid_experiment();
  experiment.n = {3, 4};
  experiment.N = {10};
  experiment.tolerance = {1e-6};
  experiment.generators[1].n = {7};
  experiment.generators[1].N = {5, 6};
  std::vector<std::vector<int>> cells;
  for (const Cell& cell : grid_of(experiment))
    cells.push_back({static_cast<int>(cell.generator), cell.n, cell.N});
  EXPECT_EQ(cells, (std::vector<std::vector<int>>{{0, 3, 10}, {0, 4, 10}, {1, 7, 5}, {1, 7, 6}}));
  experiment.grid = GridMode::paired;
  EXPECT_THROW(grid_of(experiment), InvalidParameterError) << "n = 7 has no partner";
}

TEST(Validation, RejectsEveryValueOutsideItsRange) {
  const std::vector<std::function<void(Experiment&)>> mistakes = {
      [](Experiment& e) { e.n = {0}; },
      [](Experiment& e) { e.N = {-5}; },
      [](Experiment& e) { e.tolerance = {0.0}; },
      [](Experiment& e) { e.tolerance = {1.0}; },
      [](Experiment& e) { e.tolerance = {std::numeric_limits<double>::quiet_NaN()}; },
      [](Experiment& e) { e.repetitions = 0; },
      [](Experiment& e) { e.warmup = -1; },
      [](Experiment& e) { e.threads = -1; },
      [](Experiment& e) { e.min_seconds = -1; },
      [](Experiment& e) { e.time_limit = 0; },
      [](Experiment& e) { e.generators.front().n = {0}; },
      [](Experiment& e) {
        e.generators.front().N = {3, 0};
      },
      [](Experiment& e) { e.generators.clear(); },
      [](Experiment& e) { e.methods.clear(); },
      [](Experiment& e) { e.methods.push_back(e.methods.front()); },
  };
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    Experiment experiment = grid_experiment();
    mistakes[i](experiment);
    EXPECT_THROW(validate(experiment), InvalidParameterError) << "mistake " << i;
  }
}

TEST(Experiment, HoldsNoThreadOnACoreWhoseSolvesTakeSeveral) {
  Experiment experiment = grid_experiment();
  EXPECT_TRUE(experiment.pins());
  experiment.methods.push_back({"column_generation", "two", {{"threads", std::int64_t{2}}}});
  EXPECT_FALSE(experiment.pins());
  experiment.methods.back().parameters["threads"] = std::int64_t{1};
  EXPECT_TRUE(experiment.pins());
  experiment.pin_threads = false;
  EXPECT_FALSE(experiment.pins());
}

TEST(Validation, TwoMethodsOfOneNameAreFineUnderDifferentLabels) {
  Experiment experiment = grid_experiment();
  experiment.methods = {{"m", "presolved", {}}, {"m", "", {}}};
  EXPECT_NO_THROW(validate(experiment));
  EXPECT_EQ(label_of(experiment.methods[0]), "presolved");
  EXPECT_EQ(label_of(experiment.methods[1]), "m");
}

}  // namespace
}  // namespace raygauge::test_experiment
