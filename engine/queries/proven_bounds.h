// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/methods/result.h"

namespace raygauge {

/// Bounds on a distance in R^2 or R^3 that hold, whoever goes on: what fixed-size code has proven where it
/// has no answer.
struct ProvenBounds {
  double lower = 0;
  double upper = __builtin_inf();
  double normal[3] = {0, 0, 0};  ///< that proves `lower`, as DistanceResult::normal
};

/// Betters the bounds of a result in R^n, and its status where that closes them: bounds only ever get better.
void tighten(const ProvenBounds& proven, int n, double tolerance, DistanceResult& result);

/// The answer where two objects share a point; the counters stay.
void set_overlap(DistanceResult& result);

}  // namespace raygauge
