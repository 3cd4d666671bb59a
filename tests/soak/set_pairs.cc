// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "tests/soak/set_pairs.h"

#include <cmath>

#include "engine/numerics/number_text.h"
#include "raygauge/sets/operations.h"
#include "tests/soak/random_set.h"
#include "tests/soak/result_checks.h"

namespace raygauge::soak {
namespace {

constexpr std::array<DistanceMethod, 3> kMethods = {DistanceMethod::newton, DistanceMethod::column_generation,
                                                    DistanceMethod::zheng_yamane};
constexpr double kSecondsPerPair = 1;

// The tightest proofs so far, and who gave them.
struct Proofs {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  std::string of_lower = "nobody";
  std::string of_upper = "nobody";

  void add(const DistanceResult& result, const std::string& who) {
    if (result.lower > lower) {
      lower = result.lower;
      of_lower = who;
    }
    if (result.upper < upper) {
      upper = result.upper;
      of_upper = who;
    }
  }
};

}  // namespace

SetPairs::SetPairs(std::uint64_t seed) : seed_(seed) {}

std::optional<std::string> SetPairs::check(std::int64_t number) {
  constexpr std::array<double, 3> kTolerances = {1e-12, 1e-8, 1e-3};
  RandomStream stream({seed_, 1, static_cast<int>(number >> 31), static_cast<int>(number & 0x7fffffff)},
                      "set_pairs", RandomPurpose::shape);
  const int n = stream.uniform() < 0.6 ? 3 : static_cast<int>(stream.integer(2, 6));
  const double size =
      stream.uniform() < 0.8 ? 1.0 : std::ldexp(1.0, static_cast<int>(stream.integer(-400, 400)));
  const double away = stream.uniform() < 0.1 ? 0.0 : static_cast<double>(stream.integer(1, 16)) / 4;
  const RandomSet A = draw_set(stream, draw_direction(stream, n) * away * size, size);
  const RandomSet Q = draw_set(stream, Vector::Zero(n), size);
  ++tally_.pairs;
  Proofs proofs;
  const std::string pair = A.label + " against " + Q.label + " in R^" + std::to_string(n) + ", size " +
                           shortest_text(size) + ", pair " + std::to_string(number) + ": ";
  for (std::size_t m = 0; m < kMethods.size(); ++m) {
    DistanceOptions options;
    options.method = kMethods[m];
    options.tolerance = kTolerances[static_cast<std::size_t>(stream.integer(0, 2))];
    options.time_limit = kSecondsPerPair;
    solvers_[m].set_options(options);
    const DistanceResult& result = solvers_[m].solve(*A.set, *Q.set);
    const std::string name(raygauge::to_string(kMethods[m]));
    ++tally_.solves;
    ++tally_.by_status[name][static_cast<std::size_t>(result.status)];
    const std::string what = wrong_status(result, options.tolerance);
    if (!what.empty()) return pair + name + ": " + what;
    proofs.add(result, name);
  }
  if (proofs.lower <= proofs.upper) return std::nullopt;
  return pair + "lower " + shortest_text(proofs.lower) + " of " + proofs.of_lower + " > upper " +
         shortest_text(proofs.upper) + " of " + proofs.of_upper;
}

std::string to_string(const SetPairTally& tally) {
  std::string text = std::to_string(tally.pairs) + " pairs, " + std::to_string(tally.solves) + " solves\n";
  for (const auto& [method, counts] : tally.by_status) {
    text += method + ":";
    for (std::size_t s = 0; s < counts.size(); ++s) {
      if (counts[s] == 0) continue;
      text += "  " + std::string(raygauge::to_string(static_cast<DistanceStatus>(s))) + " " +
              std::to_string(counts[s]);
    }
    text += "\n";
  }
  return text;
}

}  // namespace raygauge::soak
