// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bench/pair_bodies.h"

namespace raygauge::bench {

/// What is asked of a pair. `general` is what the engine does without fixed-size code.
enum class PairQuery : std::size_t {
  distance,
  points,  ///< with closest points
  warm,    ///< with closest points, after the motion
  general,
  growth,
  growth_warm,
  growth_general,
  apart,
  depth,       ///< with closest points, or the depth and the points in contact
  depth_warm,  ///< the same after the motion
  fcl_libccd,  ///< with closest points, as `points`
  fcl_indep,
  fcl_collide,  ///< libccd
  fcl_depth,    ///< of libccd, with the point in contact
};

inline constexpr std::size_t kPairQueries = 14;

const char* name_of(PairQuery query);

/// What the queries of the pairs of one row came to.
struct PairTally {
  std::array<std::vector<double>, kPairQueries> microseconds;
  int pairs = 0;
  int certified = 0;      ///< both distances, to the tolerance
  int fcl_pairs = 0;      ///< pairs of which FCL has both bodies
  int wrong[2] = {0, 0};  ///< answers of libccd and of FCL's own solver that are off by more than 1e-5 of the
                          ///< bodies' size, or exceptions
  double worst[2] = {0, 0};  ///< how far they are off, in units of that size
  int deep = 0;              ///< pairs that overlap ...
  int deep_certified = 0;    ///< ... with a certified depth
  int fcl_deep = 0;          ///< ... of which FCL has both bodies
  int fcl_deep_wrong = 0;    ///< ... and gives a depth that is off by more than 1e-5 of the bodies' size

  double median(PairQuery query) const;  ///< NaN where it was not asked
};

/// Times every query of one pair, all taking turns; FCL only where the build has it and FCL has the bodies.
void measure_pair(const PosedPair& pair, double tolerance, PairTally& tally);

}  // namespace raygauge::bench
