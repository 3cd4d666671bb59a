// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/identity.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/results/support.h"

namespace raygauge::test_identity {
namespace {

using testing::small_experiment;

std::string identity_after(const std::function<void(Experiment&)>& change) {
  Experiment experiment = small_experiment();
  change(experiment);
  return experiment_identity(experiment);
}

TEST(ExperimentIdentity, IsReadable) {
  Experiment experiment = small_experiment(2);
  experiment.seed = 7;
  EXPECT_EQ(experiment_identity(experiment),
            "seed = 7\n"
            "repetitions = 3\n"
            "warmup = 1\n"
            "min_seconds = 2e-5\n"
            "timing = parallel\n"
            "time_limit = 60\n"
            "grid = cartesian\n"
            "n = [3]\n"
            "N = [100, 101]\n"
            "tolerance = [1e-6]\n"
            "generators = [example2 {separation=1.5}]\n"
            "methods = [column_generation, glpk as GLPK, \"primal\" {presolve=true}]\n");
}

TEST(ExperimentIdentity, ChangesWithWhateverDeterminesTheRecords) {
  const std::string original = experiment_identity(small_experiment());
  const std::vector<std::function<void(Experiment&)>> changes = {
      [](Experiment& e) { e.seed = 2; },
      [](Experiment& e) { ++e.repetitions; },
      [](Experiment& e) { e.stop_when_within = 0.1; },
      [](Experiment& e) { ++e.warmup; },
      [](Experiment& e) { e.min_seconds *= 2; },
      [](Experiment& e) { e.timing = TimingMode::serial; },
      [](Experiment& e) { e.time_limit = 1; },
      [](Experiment& e) { e.grid = GridMode::paired; },
      [](Experiment& e) { e.n.push_back(4); },
      [](Experiment& e) { e.N.push_back(4000); },
      [](Experiment& e) { e.tolerance = {1e-7}; },
      [](Experiment& e) { e.generators.front().parameters["separation"] = 1.25; },
      [](Experiment& e) { e.generators.front().n = {5}; },
      [](Experiment& e) { e.generators.front().N = {5}; },
      [](Experiment& e) { e.methods.pop_back(); },
      [](Experiment& e) { e.methods.front().label = "ours"; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) EXPECT_NE(identity_after(changes[i]), original) << i;
}

TEST(ExperimentIdentity, StaysForWhatMayChangeBetweenSessions) {
  const std::string changed = identity_after([](Experiment& e) {
    e.name = "other";
    e.description = "other";
    e.text = "other";
    e.threads = 9;
    e.pin_threads = !e.pin_threads;
    e.shuffle = !e.shuffle;
  });
  EXPECT_EQ(changed, experiment_identity(small_experiment()));
}

TEST(ExperimentIdentity, TellsTheRuleOfAdaptiveRepetitionsWhereThereIsOne) {
  EXPECT_TRUE(identity_after([](Experiment& e) {
                e.stop_when_within = 0.05;
                e.min_repetitions = 7;
              }).ends_with("min_repetitions = 7\nstop_when_within = 0.05\n"));
  EXPECT_EQ(identity_after([](Experiment& e) { e.min_repetitions = 7; }),
            experiment_identity(small_experiment()));
}

TEST(IdentityDifference, NamesTheFirstKeyAndCountsTheOthers) {
  const std::string here = experiment_identity(small_experiment(2));
  EXPECT_EQ(identity_difference(here, here), "");
  EXPECT_EQ(identity_difference(identity_after([](Experiment& e) { e.N = {5}; }), here),
            "N = [5] there, [100, 101] here");
  const std::string there = identity_after([](Experiment& e) {
    e.repetitions = 1;
    e.N = {5};
  });
  EXPECT_EQ(identity_difference(there, here), "repetitions = 1 there, 3 here (and 1 more)");
}

TEST(IdentityDifference, SeesKeysThatOneSideLacks) {
  EXPECT_EQ(identity_difference("a = 1\nb = 2\n", "a = 1\n"), "b = 2 there, nothing here");
  EXPECT_EQ(identity_difference("a = 1\n", "a = 1\nb = 2\n"), "b = nothing there, 2 here");
}

}  // namespace
}  // namespace raygauge::test_identity
