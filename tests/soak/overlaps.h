// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::soak {

/// What became of the pairs of polytopes with integer and quarter coordinates.
struct OverlapTally {
  std::int64_t pairs = 0;
  std::int64_t overlapping = 0;  ///< with interior points in common
  std::int64_t touching = 0;     ///< with common points, but no interior ones
  std::int64_t undecided = 0;    ///< of those that touch
};

/// Random pairs of polytopes in R^2 and R^3 whose coordinates are integers, halves or quarters, as points and
/// as boxes, with poses of right angles or none: one inside the other, the same one twice, side by side. How
/// they lie is known without rounding, from integers: the origin is in the interior of the difference if no
/// plane through it leaves all differences of vertices on one side. Everything may be scaled by 1e9 or 1e-9.
///
/// Pairs with interior points in common must be `contains_origin` and `intersecting` by every query, with a
/// growth distance of at most 1; pairs that touch must not be told apart, and pairs apart must not meet.
class Overlaps {
 public:
  explicit Overlaps(std::uint64_t seed);

  /// Pair number `number` of this seed: what is false of it, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const OverlapTally& tally() const noexcept { return tally_; }

 private:
  std::uint64_t seed_;
  ObjectDistanceSolver distance_;
  GrowthDistanceSolver growth_;
  OverlapTally tally_;
};

std::string to_string(const OverlapTally& tally);

}  // namespace raygauge::soak
