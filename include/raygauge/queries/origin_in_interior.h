// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Whether the origin lies in the interior of a gauge body Q, as a gauge needs (see ConvexSet), with what
/// proves that it does not.
struct OriginInInterior {
  enum class Answer : std::uint8_t {
    holds,     ///< proven: every point has a finite distance
    violated,  ///< proven: all of Q lies to one side of the origin, u·q >= 0 for u = direction
    unknown,   ///< the time limit was reached first
  };
  Answer answer = Answer::unknown;
  Vector direction;  ///< of `violated`, n doubles (rounded); otherwise empty
};

/// Decides 0 ∈ int conv{q_j}. First two linear programs (GaugeBound); if they prove nothing, the distances of
/// n + 3 points: two generic ones, e_1, …, e_n and -(e_1 + … + e_n), each scaled by the size of Q. All are
/// finite if and only if 0 is in the interior.
OriginInInterior origin_in_interior(const PointSet& Q,
                                    double time_limit = std::numeric_limits<double>::infinity());

}  // namespace raygauge
