// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "raygauge/sets/pose.h"

namespace raygauge::bench {

/// A pair of bodies in poses, and where the second one is after a motion of 0.01 rad and 0.002 of its size.
struct PosedPair {
  std::shared_ptr<const ConvexSet> first, second;
  Pose pose_1{3}, pose_2{3}, moved_2{3};
  double size =
      1;  ///< of the bodies: they lie within `size` of their origins, but for the needles' half length
};

/// "hull N" and "points N" are N points on the unit sphere, prepared and raw; "cone" is a truncated cone,
/// "pointed" one with its tip.
std::vector<std::string> body_kinds();

/// How pairs stand. "apart": centres 3 apart. Unfriendly ones: "touching", "1e-9" and "1e-4" (moved along the
/// normal until they are so far apart), "slight" (until they overlap by 0.01), "overlap" (centres 0.3 apart),
/// "concentric", "parallel" (poses without a rotation), "needles" (1e6 : 1), "large" and "small" (1e±6 times
/// the size).
std::vector<std::string> pair_places();

bool is_polytope(const std::string& kind);

/// Pair number `seed` of two kinds.
PosedPair make_pair(const std::string& one, const std::string& two, const std::string& place, int seed);

}  // namespace raygauge::bench
