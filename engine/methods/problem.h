// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/numerics/stopwatch.h"
#include "engine/proof/bounds.h"
#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

class SupportPairs;

/// What a method is asked: d_Q(A), as far as the options say and the stopwatch allows.
struct Problem {
  const ConvexSet& A;
  const ConvexSet& Q;
  const DistanceOptions& options;
  const Stopwatch& stopwatch;
  Effects effects = Effects::none;

  /// A direction u to begin with, n doubles, where the method can use one; nullptr: none is known.
  const double* start = nullptr;

  /// The solve also ends, as `optimal`, when the bounds exclude this value; NaN: none.
  double threshold = Goal().threshold;

  /// Where A is an ObjectPair whose combination will be taken apart: A is asked through this.
  SupportPairs* pairs = nullptr;

  Goal goal() const noexcept { return {options.tolerance, threshold}; }
};

/// Bounds, with an estimate of d that they are to hold: one that is not a number gives way to the lower one.
inline void write_bounds(const Bounds& bounds, double estimate, DistanceStatus status,
                         DistanceResult& result) {
  result.status = status;
  result.lower = bounds.lower();
  result.upper = bounds.upper();
  result.distance = std::max(result.lower, std::min(estimate, result.upper));
}

}  // namespace raygauge
