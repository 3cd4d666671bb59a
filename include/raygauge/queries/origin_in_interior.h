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
    unknown,   ///< the time limit came first
  };
  Answer answer = Answer::unknown;
  Vector direction;  ///< of `violated`, n doubles (rounded); otherwise empty
};

/// Decides 0 ∈ int conv{q_j}: by GaugeBound where that proves it, and otherwise by the distances of n + 1
/// points that span R^n positively, e_1, …, e_n and -(e_1 + … + e_n), each e_k times the size of Q along it:
/// all of them are finite exactly where the cone of Q is R^n, that is where 0 is interior.
OriginInInterior origin_in_interior(const PointSet& Q,
                                    double time_limit = std::numeric_limits<double>::infinity());

}  // namespace raygauge
