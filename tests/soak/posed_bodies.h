// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::soak {

/// What became of the queries about posed bodies.
struct PosedBodyTally {
  std::int64_t pairs = 0;
  std::int64_t frames = 0;
  std::int64_t certified = 0;  ///< queries with a final status, of two a frame
};

/// Random posed pairs of bodies of R^2 and R^3, near and far, touching and overlapping, over a few frames of
/// a motion. Each frame's Euclidean distance and growth distance are solved by the default way, cold or from
/// a WarmStart that may be of another pair, and by the general methods, whose proofs are others. The bounds
/// must not contradict each other.
class PosedBodies {
 public:
  explicit PosedBodies(std::uint64_t seed);

  /// Pair number `number` of this seed: what is false of it, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const PosedBodyTally& tally() const noexcept { return tally_; }

 private:
  std::uint64_t seed_;
  ObjectDistanceSolver distance_, general_distance_;
  GrowthDistanceSolver growth_, general_growth_;
  WarmStart warm_distance_, warm_growth_;  // left by the pair before
  PosedBodyTally tally_;
};

std::string to_string(const PosedBodyTally& tally);

}  // namespace raygauge::soak
