// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "tests/soak/random_set.h"

namespace raygauge::soak {

/// What became of the pairs of bodies placed at a known distance.
struct PlacedBodyTally {
  std::int64_t poses = 0;      ///< of a pair; one query each, or two where they overlap
  std::int64_t warm = 0;       ///< of them from a WarmStart
  std::int64_t overlaps = 0;   ///< of them with interior points in common
  std::int64_t certified = 0;  ///< with a final status
};

/// Random pairs of bodies of R^2 and R^3, placed in random poses such that their distance is known, for no
/// more than two support queries. For any direction u and points a of A1 and b of A2 where u·a is highest and
/// u·b is lowest, the Euclidean distance is d if b - a = d u, and the growth distance about the centres c_1,
/// c_2 is σ if  c_2 - c_1 = σ ((a - c_1) - (b - c_2)). Poses are numbers in doubles, so what is really known
/// is an enclosure, computed in long double from those numbers: u proves a lower bound by weak duality, a and
/// b an upper one. It shares nothing with the engine but the sets' own support mappings.
///
/// u is random, along an axis, the normal of a face or of two edges, or nearly that of the pose before; a and
/// b are vertices, or points of the edge or face that has this normal. Distances are 0, of the size of the
/// bodies, or down to 1e-9 of it; some bodies overlap.
///
/// The solvers are used ones: several pairs of kinds of their own take turns at random, and so do the
/// queries. Pairs that meet when they are scaled by less than 1 must overlap by all queries.
class PlacedBodies {
 public:
  explicit PlacedBodies(std::uint64_t seed);

  /// Poses of all pairs of one check.
  static constexpr int kPoses = 250;

  /// Some pairs of bodies, number `number` of this seed, in all their poses: what is false of them, or
  /// nothing.
  std::optional<std::string> check(std::int64_t number);

  const PlacedBodyTally& tally() const noexcept { return tally_; }

 private:
  struct Turn;
  std::string check(Turn& turn);

  std::uint64_t seed_;
  ObjectDistanceSolver distance_;
  GrowthDistanceSolver growth_;
  WarmStart warm_distance_, warm_growth_;  // left by any pair before
  PlacedBodyTally tally_;
};

std::string to_string(const PlacedBodyTally& tally);

}  // namespace raygauge::soak
