// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/methods/options.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// For gauges of S at points.
DistanceOptions options_of_membership(const ConvexSet& S, double tolerance);

}  // namespace raygauge
