// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/component.h"

#include <gtest/gtest.h>

#include "raygauge/exceptions.h"

namespace raygauge::test_component {
namespace {

Instance no_sets(const InstanceKey& key, const Parameters& parameters) {
  return {nullptr, nullptr, key.n + real_parameter(parameters, "shift")};
}

std::unique_ptr<Generator> shifted() {
  const auto component =
      generator_component("shifted", "a test", {{"shift", 0.5, 0.0, 1.0, "", {}}}, no_sets, 2);
  return component.make({{"shift", 0.25}});
}

TEST(GeneratorComponent, PassesKeyAndParametersOn) {
  EXPECT_EQ(shifted()->generate({1, 3, 1, 0}).exact_distance, 3.25);
}

TEST(GeneratorComponent, RefusesKeysOutsideTheFamily) {
  EXPECT_THROW(shifted()->generate({1, 1, 1, 0}), InvalidParameterError);
  EXPECT_THROW(shifted()->generate({1, 2, 0, 0}), InvalidParameterError);
  EXPECT_THROW(shifted()->generate({1, 2, 1, -1}), InvalidParameterError);
}

TEST(GeneratorComponent, NamesTheGeneratorAndTheValueInItsMessage) {
  try {
    shifted()->generate({1, 1, 1, 0});
    FAIL() << "accepted n = 1";
  } catch (const InvalidParameterError& error) {
    EXPECT_STREQ(error.what(), "generator 'shifted': n must be at least 2, got 1");
  }
}

}  // namespace
}  // namespace raygauge::test_component
