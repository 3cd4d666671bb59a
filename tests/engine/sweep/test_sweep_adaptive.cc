// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Sweeps that repeat a cell until its medians are known, on planted times.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <span>

#include "engine/sweep/repetitions.h"
#include "tests/engine/fake_sweep.h"

namespace raygauge::test_sweep_adaptive {
namespace {

using testing::expect_same_outcome;
using testing::MemorySink;
using testing::planted_times;
using testing::small_experiment;

/// A number in [0, 1) without pattern, of which a distance is the seed.
double scatter(double distance) {
  const double x = 1e4 * std::sin(1e4 * distance);
  return x - std::floor(x);
}

class AdaptiveSweep : public testing::FakeSweep {
 protected:
  AdaptiveSweep() {
    experiment_.repetitions = 60;
    experiment_.stop_when_within = 0.2;
    experiment_.methods[1].parameters["error"] = 1e-9;  // other distances, other times
  }

  std::unique_ptr<MemorySink> sweep(const std::function<double(double)>& seconds,
                                    const std::set<std::uint64_t>& done = {}) {
    auto sink = std::make_unique<MemorySink>();
    SweepHooks hooks;
    hooks.time = planted_times(seconds);
    run(experiment_, *sink, done, hooks);
    return sink;
  }

  Experiment experiment_ = small_experiment();
};

std::set<std::size_t> record_counts(const MemorySink& sink) {
  std::set<std::size_t> counts;
  for (const auto& entry : sink.cells()) counts.insert(entry.second.records.size());
  return counts;
}

TEST_F(AdaptiveSweep, EndsACellAtTheFirstLookWhereAllTimesAreEqual) {
  EXPECT_EQ(record_counts(*sweep([](double) { return 1e-3; })), (std::set<std::size_t>{2 * 10}));
}

TEST_F(AdaptiveSweep, GoesOnToTheLimitWhereTimesScatterTooMuch) {
  const auto wild = [](double distance) { return std::exp(8 * scatter(distance)); };
  EXPECT_EQ(record_counts(*sweep(wild)), (std::set<std::size_t>{2 * 60}));
}

TEST_F(AdaptiveSweep, OneMethodWithUncertainTimesKeepsAllInTheCell) {
  const auto wild_if_second = [](double distance) {
    const bool second = std::abs(1e4 * distance - std::round(1e4 * distance)) > 1e-6;
    return second ? std::exp(8 * scatter(distance)) : 1e-3;
  };
  EXPECT_EQ(record_counts(*sweep(wild_if_second)), (std::set<std::size_t>{2 * 60}));
}

TEST_F(AdaptiveSweep, IsOffUnlessAskedFor) {
  experiment_.stop_when_within = 0;
  EXPECT_EQ(record_counts(*sweep([](double) { return 1e-3; })), (std::set<std::size_t>{2 * 60}));
}

/// Times that need some but not all repetitions.
double moderate(double distance) { return 1 + 0.5 * scatter(distance); }

TEST_F(AdaptiveSweep, EveryCellEndsAtTheFirstLookAtWhichItsOwnTimesSaySo) {
  const auto sink = sweep(moderate);
  EXPECT_GT(record_counts(*sink).size(), 1u) << "a test of one number only";
  for (const auto& [index, cell] : sink->cells()) {
    int done = 0;
    do {
      done = next_look(experiment_, done);
      ASSERT_LE(2u * static_cast<std::size_t>(done), cell.records.size()) << index;
    } while (done < experiment_.repetitions &&
             !medians_known(std::span(cell.records).first(2 * static_cast<std::size_t>(done)), 2, 0.2));
    EXPECT_EQ(cell.records.size(), 2 * static_cast<std::size_t>(done)) << index;
  }
}

TEST_F(AdaptiveSweep, WithEqualTimesHasEqualRecordsForAnyThreadsAndOrder) {
  experiment_.threads = 1;
  const auto reference = sweep(moderate);
  for (const int threads : {1, 2}) {
    for (const bool shuffle : {false, true}) {
      experiment_.threads = threads;
      experiment_.shuffle = shuffle;
      expect_same_outcome(*reference, *sweep(moderate));
    }
  }
}

TEST_F(AdaptiveSweep, ResumedWithEqualTimesHasTheRecordsOfAnUndisturbedOne) {
  const auto reference = sweep(moderate);
  for (std::uint64_t kept = 0; kept < reference->cells().size(); kept += 3) {
    std::set<std::uint64_t> done;
    for (std::uint64_t cell = 0; cell < kept; ++cell) done.insert(cell);
    const auto sink = sweep(moderate, done);
    for (const std::uint64_t cell : done) sink->store(reference->cells().at(cell));
    expect_same_outcome(*reference, *sink);
  }
}

TEST_F(AdaptiveSweep, RecordsAreThoseOfTheFixedNumberAsFarAsTheyGo) {
  const auto some = sweep(moderate);
  experiment_.stop_when_within = 0;
  const auto all = sweep(moderate);
  for (const auto& [index, cell] : some->cells()) {
    for (std::size_t i = 0; i < cell.records.size(); ++i) {
      expect_same_outcome(all->cells().at(index).records[i], cell.records[i]);
    }
  }
}

TEST_F(AdaptiveSweep, RefusesLimitsThatContradictEachOther) {
  const auto refusal = [this](const std::function<void(Experiment&)>& change) {
    Experiment experiment = experiment_;
    change(experiment);
    EXPECT_THROW(validate(experiment), InvalidParameterError);
  };
  refusal([](Experiment& e) { e.stop_when_within = 1.1; });
  refusal([](Experiment& e) { e.stop_when_within = -0.1; });
  refusal([](Experiment& e) { e.min_repetitions = 5; });
  refusal([](Experiment& e) { e.repetitions = 9; });
}

}  // namespace
}  // namespace raygauge::test_sweep_adaptive
