// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/numerics/threshold.h"

/// What was found by measurement for column generation.
namespace raygauge::tuned {

/// Coordinates of both sets up to which a pass costs less than the pivots it may spare.
inline constinit const Threshold<std::ptrdiff_t> kCheapNumbers{std::ptrdiff_t{1} << 17};

/// Dimensions from which on a simplex may stall for longer than the interior-point method takes.
inline constinit const Threshold<int> kLeastToStall{16};

/// Points of both sets for each dimension up to which they are few, and beyond which they are many.
inline constinit const Threshold<std::ptrdiff_t> kFewPointsPerDimension{8};
inline constinit const Threshold<std::ptrdiff_t> kManyPointsPerDimension{60};

/// Dimensions from which on the interior-point method finds the optimal basis, or that there is none, sooner
/// than the simplex does: of few, some and many points.
inline constinit const Threshold<int> kInteriorOfFew{110};
inline constinit const Threshold<int> kInteriorOfSome{130};
inline constinit const Threshold<int> kInteriorOfMany{200};

/// Dimensions from which on it pays to look whether points of Q stand on the axes.
inline constinit const Threshold<int> kLeastForAxes{16};

/// How far the first normal may be from its guess, relative, beyond the spacing of the points: where all
/// points are priced from the start, bounds too narrow, which have to be raised, cost more than bounds too
/// wide; a normal of a sample had better stay near the guess.
inline constinit const Threshold<double> kNormalErrorOfFew{0.15};
inline constinit const Threshold<double> kNormalErrorOfMany{0.05};
inline constinit const Threshold<double> kNormalErrorOfSample{0.02};
inline constinit const Threshold<double> kSpacingsOfSample{0.8};

/// Dimensions up to which the first two hold: those in which the simplex chooses basis changes by a tableau.
inline constinit const Threshold<int> kDimensionsOfTableau{10};

/// Points just below the threshold are the next to be violated when the normal turns: those within this
/// fraction of the last pass's violation are taken along.
inline constinit const Threshold<double> kReachOfViolators{0.2};

/// Dimensions from which on a pass over a shortlist takes less than one over the working set.
inline constinit const Threshold<int> kShortlistDimension{16};

}  // namespace raygauge::tuned
