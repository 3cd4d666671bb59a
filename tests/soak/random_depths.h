// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generators/random.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::soak {

/// What became of the pairs of bodies whose depth was asked for.
struct RandomDepthTally {
  std::int64_t poses = 0;      ///< of a pair; one query each
  std::int64_t depths = 0;     ///< of them not apart
  std::int64_t certified = 0;  ///< of these with a final status
  std::int64_t facets = 0;     ///< of these polytopes, whose depth is known from all their facets
};

/// Depths of random bodies of R^2 and R^3 that overlap, in random poses, against what is known of them by the
/// sets' own support mappings, in long double:
///
/// - of polytopes of few points, half of them on a coarse grid, some flat as a sheet, the depth itself: the
///   least height over the normals of all triples of points of either one and of all pairs of edges;
/// - of all bodies an upper bound: the least height over random directions, over the one that they were
///   placed by, and over a descent from the reported normal; no lower bound may be above it;
/// - the height of the reported normal, which no upper bound may be below.
///
/// Bodies are placed at a known height of a random direction, from 1e-10 of their size to that, or with their
/// centres near each other, or on a coarse grid.
class RandomDepths {
 public:
  explicit RandomDepths(std::uint64_t seed);

  /// Poses of one pair of bodies.
  static constexpr int kPoses = 20;

  /// Pair number `number` of this seed in all its poses: what is false of it, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const RandomDepthTally& tally() const noexcept { return tally_; }

 private:
  std::uint64_t seed_;
  ObjectDistanceSolver solver_;
  WarmStart warm_;
  RandomDepthTally tally_;
};

std::string to_string(const RandomDepthTally& tally);

}  // namespace raygauge::soak
