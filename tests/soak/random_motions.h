// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "generators/random.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/scene/continuous.h"

namespace raygauge::soak {

/// What became of the motions.
struct MotionTally {
  std::int64_t motions = 0;
  std::int64_t grazing = 0;  ///< moved so that the bodies just touch or just miss
  std::int64_t contacts = 0;
  std::int64_t free = 0;
  std::int64_t undecided = 0;
  std::int64_t tests = 0;  ///< exact tests at single moments
  std::int64_t exact = 0;  ///< motions known in quadruple precision: not among the others
  std::int64_t exact_undecided = 0;
};

/// Random pairs of moving bodies of R^2 and R^3, all kinds of sets, many of them spinning fast, over the time
/// [0, 1]. Their time of impact is compared with cold distances at single moments: on a grid, around the
/// grid's least distance, and where they overlap, at the first moment of a bisection. Of every fiftieth
/// motion the general methods compute them. A third are motions of ExactMotion, with clearances too.
class RandomMotions {
 public:
  explicit RandomMotions(std::uint64_t seed);

  /// Motion number `number` of this seed: what is false of its time of impact, or nothing.
  std::optional<std::string> check(std::int64_t number);

  const MotionTally& tally() const noexcept { return tally_; }

 private:
  struct Pair;

  std::optional<std::string> check_exact(RandomStream& stream, std::int64_t number);
  DistanceResult distance(const Pair& pair, double t);
  bool overlap(const Pair& pair, double t);
  double nearest_moment(const Pair& pair, double from, double to);
  double first_overlap(const Pair& pair, double last);
  bool graze(Pair& pair, double gap);

  std::uint64_t seed_;
  ObjectDistanceSolver distance_, general_distance_;
  GrowthDistanceSolver growth_;
  MotionTally tally_;
};

std::string to_string(const MotionTally& tally);

}  // namespace raygauge::soak
