// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "engine/numerics/stopwatch.h"
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
  double threshold = std::numeric_limits<double>::quiet_NaN();

  /// Where A is an ObjectPair whose combination will be taken apart: A is asked through this.
  SupportPairs* pairs = nullptr;
};

}  // namespace raygauge
