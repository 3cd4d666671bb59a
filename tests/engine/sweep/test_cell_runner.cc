// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sweep/cell_runner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tests/engine/fake_components.h"

namespace raygauge::test_cell_runner {
namespace {

class Cells : public ::testing::Test {
 protected:
  CellResult run(const Experiment& experiment) {
    const SweepPlan plan(experiment, generators_, methods_);
    return CellRunner(plan, {2, 5, SteadyClock::now()}).run(plan.cells().front()).value();
  }

  /// (repetition, method) in the order in which the solves took place.
  static std::vector<std::pair<int, std::string>> order_of(const CellResult& cell) {
    std::vector<Record> records = cell.records;
    std::stable_sort(records.begin(), records.end(),
                     [](const Record& a, const Record& b) { return a.started_at < b.started_at; });
    std::vector<std::pair<int, std::string>> order;
    for (const Record& record : records) order.emplace_back(record.repetition, record.method);
    return order;
  }

  testing::CallLog log_;
  GeneratorRegistry generators_ = testing::fake_generators();
  MethodRegistry methods_ = testing::fake_methods(log_);
};

TEST_F(Cells, RecordsStandByRepetitionAndMethodWhateverTheirOrderInTime) {
  Experiment experiment = testing::small_experiment();
  experiment.repetitions = 20;
  const CellResult cell = run(experiment);
  ASSERT_EQ(cell.records.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(cell.records[i].repetition, static_cast<int>(i / 2));
    EXPECT_EQ(cell.records[i].method, i % 2 == 0 ? "first" : "second");
    EXPECT_EQ(cell.records[i].thread, 2);
    EXPECT_EQ(cell.records[i].concurrency, 5);
  }
}

TEST_F(Cells, MethodsAndRepetitionsAreInterleavedAtRandomFromTheSeed) {
  Experiment experiment = testing::small_experiment();
  experiment.repetitions = 20;
  const auto order = order_of(run(experiment));
  EXPECT_FALSE(std::is_sorted(order.begin(), order.end()));
  EXPECT_EQ(order_of(run(experiment)), order);
  experiment.seed = 8;
  EXPECT_NE(order_of(run(experiment)), order);
}

TEST_F(Cells, LargeInstancesAreTakenInBatchesThatFitIntoMemory) {
  Experiment experiment = testing::small_experiment();
  experiment.n = {80};
  experiment.N = {1000000};  // 1.3 GB an instance, if the fake ones were as large as they claim
  const auto order = order_of(run(experiment));
  ASSERT_EQ(order.size(), 8u);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i].first, static_cast<int>(i / 2));
}

TEST_F(Cells, BatchesOfOneSizeHaveOrdersOfTheirOwn) {
  Experiment experiment = testing::small_experiment();
  experiment.n = {80};
  experiment.N = {1000000};  // a batch is one repetition
  experiment.repetitions = 20;
  std::set<std::string> first_methods;
  const auto order = order_of(run(experiment));
  for (std::size_t i = 0; i < order.size(); i += 2) first_methods.insert(order[i].second);
  EXPECT_EQ(first_methods, (std::set<std::string>{"first", "second"}));
}

TEST_F(Cells, TheExactDistanceIsTheGenerators) {
  const Experiment experiment = testing::small_experiment();
  for (const Record& record : run(experiment).records) {
    EXPECT_EQ(record.exact_distance, 0.5 + 1 + 3 + 0.01 + 0.1 * record.repetition + 7);
    EXPECT_TRUE(record.agrees);
  }
}

}  // namespace
}  // namespace raygauge::test_cell_runner
