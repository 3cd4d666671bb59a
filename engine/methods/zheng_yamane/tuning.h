// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/numerics/threshold.h"

/// What was found by measurement for the method of Zheng & Yamane.
namespace raygauge::tuned {

/// Dimensions from which on the numbers "of many" hold.
inline constinit const Threshold<int> kManyDimensionsOfRays{16};

/// How far the first normals of a cold ray may be from -a_c, in parts of its largest entry.
inline constinit const Threshold<double> kRayMarginOfFew{0.14};
inline constinit const Threshold<double> kRayMarginOfMany{0.5};

/// A ray is left where a bound so many times its η turns up. In many dimensions shorter rays would be left
/// too often.
inline constinit const Threshold<double> kOvertakingInFew{1.3};  // of point sets
inline constinit const Threshold<double> kOvertakingInMany{2};

/// The first ray, at an η far from the distance, is shot this loosely: its end would be left at the next η
/// anyway.
inline constinit const Threshold<double> kFirstRayTolerance{0.03};

/// Pricings of the shortlists after a pass over all points.
inline constinit const Threshold<int> kShortlistQueries{8};

/// Of the pass's own reduced cost: a column of a shortlist that promises less waits for a better one.
inline constinit const Threshold<double> kRayWorthEntering{0.4};

}  // namespace raygauge::tuned
