// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What generators declare of their instances holds.
#include <gtest/gtest.h>

#include <cmath>

#include "generators/component.h"
#include "tests/generators/points_of.h"

namespace raygauge::test_generator_promises {
namespace {

/// The defaults, and them with one parameter at another of its choices.
std::vector<Parameters> variants_of_one(const Component<Generator>& component) {
  std::vector<Parameters> variants(1);
  for (const ParameterInfo& info : component.parameters) {
    for (const std::string& choice : info.choices) variants.push_back({{info.name, choice}});
    if (std::holds_alternative<bool>(info.default_value)) {
      variants.push_back({{info.name, true}});
      variants.push_back({{info.name, false}});
    }
  }
  return variants;
}

/// The defaults, and them with one parameter, or two, at another of its choices.
std::vector<Parameters> variants_of(const Component<Generator>& component) {
  std::vector<Parameters> variants = variants_of_one(component);
  const std::vector<Parameters> one = variants;
  for (const Parameters& first : one) {
    for (const Parameters& second : one) {
      Parameters both = first;
      both.insert(second.begin(), second.end());
      if (both.size() == 2) variants.push_back(std::move(both));
    }
  }
  return variants;
}

bool states_every_distance(const Component<Generator>& component) {
  for (const Parameters& parameters : variants_of(component)) {
    const auto generator = all_generators().make(component.name, parameters);
    for (const int n : {2, 3, 5}) {
      for (const int repetition : {0, 1, 2}) {
        if (!generator->generate({7, n, 12, repetition}).exact_distance) return false;
      }
    }
  }
  return true;
}

TEST(GeneratorPromises, AKnownDistanceIsStatedForEveryInstanceAndOnlyThenPromised) {
  for (const std::string& name : all_generators().names()) {
    const Component<Generator>& component = all_generators().find(name);
    EXPECT_EQ(component.promises.known_distance, states_every_distance(component)) << name;
  }
}

TEST(GeneratorPromises, ARoundingIsOneOfAStatedDistance) {
  for (const std::string& name : all_generators().names()) {
    const GeneratorPromises& promises = all_generators().find(name).promises;
    EXPECT_GE(promises.distance_rounding, 0) << name;
    EXPECT_TRUE(promises.distance_rounding == 0 || promises.known_distance) << name;
  }
  EXPECT_EQ(all_generators().find("example1").promises.distance_rounding, 0x1p-45);
}

TEST(GeneratorPromises, EveryParameterHasAUnitAndAMeasureOfHardnessIsANumber) {
  for (const std::string& name : all_generators().names()) {
    int measures = 0;
    for (const ParameterInfo& info : all_generators().find(name).parameters) {
      EXPECT_FALSE(info.unit.empty()) << name << ' ' << info.name;
      if (info.hardness.label.empty()) continue;
      ++measures;
      EXPECT_FALSE(std::holds_alternative<std::string>(info.default_value)) << name << ' ' << info.name;
    }
    EXPECT_LE(measures, 1) << name;
  }
}

TEST(GeneratorPromises, HardnessGrowsWithThePowerAndTheReciprocal) {
  EXPECT_EQ(reciprocal(0.25), 4);
  EXPECT_EQ(power_of_two(-3), 0.125);
}

}  // namespace
}  // namespace raygauge::test_generator_promises
