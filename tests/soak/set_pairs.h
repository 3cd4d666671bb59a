// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "raygauge/queries/solver.h"

namespace raygauge::soak {

/// What became of the solves of pairs of convex sets.
struct SetPairTally {
  std::int64_t pairs = 0;
  std::int64_t solves = 0;
  std::map<std::string, std::array<std::int64_t, 6>>
      by_status;  ///< by method, in the order of DistanceStatus
};

/// Random pairs of convex sets of every kind (draw_set) solved by `newton`, `column_generation` and
/// `zheng_yamane`, in solvers that remember the pairs before. Nobody knows the distances; but all bounds are
/// proven, so no lower bound of one method may exceed an upper bound of another.
class SetPairs {
 public:
  explicit SetPairs(std::uint64_t seed);

  /// Pair number `number` of this seed: what is false of it, with the labels of both sets, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const SetPairTally& tally() const noexcept { return tally_; }

 private:
  std::uint64_t seed_;
  std::array<DistanceSolver, 3> solvers_;
  SetPairTally tally_;
};

std::string to_string(const SetPairTally& tally);

}  // namespace raygauge::soak
