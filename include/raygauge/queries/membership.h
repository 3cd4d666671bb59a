// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// lower <= gauge_S(x) <= upper, both proven. The gauge is min{t >= 0 : x in tS}: +infinity where no multiple
/// of S contains x.
struct GaugeBounds {
  double lower = 0;
  double upper = 0;
};

/// The gauge of S at x, for every set. It comes from the set's own formula where it has one, and is otherwise
/// the distance of {x} in the gauge of S. Its relative gap is `tolerance` where the proof reaches it. Throws
/// DimensionMismatchError, NonFiniteError, or InvalidParameterError unless 0 < tolerance < 1.
GaugeBounds gauge(const ConvexSet& S, const ConstVectorRef& x, double tolerance = 1e-6);

/// Whether x lies in S, as far as it is proven.
enum class Membership : std::uint8_t {
  inside,
  outside,
  undecided,  ///< x is within about `tolerance` of the boundary, relative to its distance from
              ///< the centre
};

/// Computes the gauge about the centre c: x in S if and only if gauge_{S - c}(x - c) <= 1. Throws as
/// gauge().
Membership contains(const ConvexSet& S, const ConstVectorRef& x, double tolerance = 1e-6);

}  // namespace raygauge
