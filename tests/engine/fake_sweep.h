// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <vector>

#include "tests/engine/fake_components.h"

namespace raygauge::testing {

/// Sweeps over the fake components.
class FakeSweep : public ::testing::Test {
 protected:
  SweepSummary run(const Experiment& experiment, RecordSink& sink, const std::set<std::uint64_t>& done = {},
                   const SweepHooks& hooks = {}) {
    return run_sweep(experiment, generators_, methods_, sink, done, hooks);
  }

  CallLog log_;
  GeneratorRegistry generators_ = fake_generators();
  MethodRegistry methods_ = fake_methods(log_);
};

/// Everything that may not depend on threads, order or timing.
inline void expect_same_outcome(const Record& a, const Record& b) {
  EXPECT_EQ(a.cell, b.cell);
  EXPECT_EQ(a.generator, b.generator);
  EXPECT_EQ(a.generator_parameters, b.generator_parameters);
  EXPECT_EQ(a.method, b.method);
  EXPECT_EQ(a.method_parameters, b.method_parameters);
  EXPECT_EQ(a.n, b.n);
  EXPECT_EQ(a.N, b.N);
  EXPECT_EQ(a.tolerance, b.tolerance);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.repetition, b.repetition);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.lower, b.lower);
  EXPECT_EQ(a.upper, b.upper);
  EXPECT_EQ(a.exact_distance, b.exact_distance);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.agrees, b.agrees);
  EXPECT_EQ(a.counters, b.counters);
}

inline void expect_same_outcome(const MemorySink& a, const MemorySink& b) {
  ASSERT_EQ(a.cells().size(), b.cells().size());
  for (const auto& [index, cell] : a.cells()) {
    EXPECT_EQ(b.times_stored(index), 1);
    const std::vector<Record>& others = b.cells().at(index).records;
    ASSERT_EQ(cell.records.size(), others.size());
    for (std::size_t i = 0; i < others.size(); ++i) expect_same_outcome(cell.records[i], others[i]);
  }
}

}  // namespace raygauge::testing
