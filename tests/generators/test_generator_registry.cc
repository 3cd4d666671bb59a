// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What holds for every generator of the room, whichever it is.
#include "generators/registry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <thread>

#include "generators/random.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_generator_registry {
namespace {

/// Bit for bit; sets that are no point sets by their support points in 50 directions.
bool same_set(const std::shared_ptr<const ConvexSet>& one, const std::shared_ptr<const ConvexSet>& other) {
  if (dynamic_cast<const PointSet*>(one.get()) != nullptr) return points_of(one) == points_of(other);
  RandomStream stream({}, "directions", RandomPurpose::shape);
  for (int i = 0; i < 50; ++i) {
    const Vector u = stream.unit_vector(one->dimension());
    if (one->support_mapping(u) != other->support_mapping(u)) return false;
  }
  return true;
}

bool same(const Instance& one, const Instance& other) {
  return same_set(one.A, other.A) && same_set(one.Q, other.Q) && one.exact_distance == other.exact_distance;
}

class EveryGenerator : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Generator> generator() const { return all_generators().make(GetParam(), {}); }
};

TEST_P(EveryGenerator, MakesTheSameInstanceAgainInAnyOrderAndThread) {
  const InstanceKey key{11, 3, 12, 4};
  const Instance first = generator()->generate(key);
  const auto shared = generator();
  shared->generate({11, 3, 12, 5});
  std::optional<Instance> elsewhere;
  std::thread([&] { elsewhere = shared->generate(key); }).join();
  EXPECT_TRUE(same(first, *elsewhere));
}

// Few of the smallest families' instances differ, but not all of them may be one.
TEST_P(EveryGenerator, DependsOnSeedAndRepetition) {
  const auto made = generator();
  const Instance base = made->generate({1, 3, 12, 0});
  bool seed_matters = false, repetition_matters = false;
  for (int i = 1; i <= 20; ++i) {
    seed_matters |= !same(base, made->generate({1 + static_cast<std::uint64_t>(i), 3, 12, 0}));
    repetition_matters |= !same(base, made->generate({1, 3, 12, i}));
  }
  EXPECT_TRUE(seed_matters);
  EXPECT_TRUE(repetition_matters);
}

TEST_P(EveryGenerator, LivesInTheDimensionAskedFor) {
  for (const int n : {2, 3, 5}) {
    const Instance instance = generator()->generate({1, n, 20, 0});
    EXPECT_EQ(instance.A->dimension(), n);
    EXPECT_EQ(instance.Q->dimension(), n);
  }
}

TEST_P(EveryGenerator, SaysWhatItIs) {
  const auto& component = all_generators().find(GetParam());
  EXPECT_FALSE(component.description.empty());
  for (const auto& parameter : component.parameters) EXPECT_FALSE(parameter.description.empty());
}

INSTANTIATE_TEST_SUITE_P(Room, EveryGenerator, testing::ValuesIn(all_generators().names()),
                         [](const auto& test) { return test.param; });

class PairOfClouds : public testing::TestWithParam<std::string> {};

TEST_P(PairOfClouds, HasNPointsInEachSet) {
  const auto instance = all_generators().make(GetParam(), {})->generate({1, 3, 12, 0});
  EXPECT_EQ(points_of(instance.A).cols(), 12);
  EXPECT_EQ(points_of(instance.Q).cols(), 12);
}

INSTANTIATE_TEST_SUITE_P(Room, PairOfClouds,
                         testing::Values("example2", "clustered", "needle", "hard_planted_ties",
                                         "hard_planted_unimodular", "hard_planted_origin",
                                         "hard_planted_unreachable", "hard_scaled", "hard_scaled_object",
                                         "hard_moment_curve"),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace raygauge::test_generator_registry
