// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// Random pairs of convex sets by every method; stops at the first whose proofs contradict each other:
// docs/soak.md.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "tests/soak/set_pairs.h"

int main(int count, char** arguments) {
  std::int64_t pairs = 100000, first = 0;
  std::uint64_t seed = 1;
  CLI::App app(
      "Solves random pairs of convex sets by every method; stops where two proofs contradict each other.");
  app.option_defaults()->always_capture_default();
  app.add_option("--pairs", pairs, "how many")->check(CLI::PositiveNumber);
  app.add_option("--first", first, "number of the first pair")->check(CLI::NonNegativeNumber);
  app.add_option("--seed", seed, "seed of all random numbers");
  CLI11_PARSE(app, count, arguments);
  raygauge::soak::SetPairs soak(seed);
  for (std::int64_t i = first; i < first + pairs; ++i) {
    if (const auto violation = soak.check(i)) {
      std::printf("%sviolation: %s\n", to_string(soak.tally()).c_str(), violation->c_str());
      return 1;
    }
  }
  std::printf("%sviolations: 0\n", to_string(soak.tally()).c_str());
  return 0;
}
