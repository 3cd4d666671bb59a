// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/threshold.h"

/// What was found by measurement for the nearest point of a polytope.
namespace raygauge::tuned {

/// A point of the shortlist that gains less than this share of what the best one of its pass did waits for
/// the next pass.
inline constinit const Threshold<double> kPointWorthEntering{0.3};

/// Points that enter after one pass.
inline constinit const Threshold<int> kPointsOfOnePass{16};

}  // namespace raygauge::tuned
