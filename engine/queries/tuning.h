// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/numerics/threshold.h"

/// What was found by measurement for questions about many points at once.
namespace raygauge::tuned {

/// Points from which on gauges are found by walks along facets; and points of S for each dimension, below
/// which single solves are as quick.
inline constinit const Threshold<std::ptrdiff_t> kLeastForWalks{1024};
inline constinit const Threshold<std::ptrdiff_t> kLeastPointsOfWalks{60};

/// Points of a group of such walks, on average; and where points are few: points of a group, and groups at
/// most.
inline constinit const Threshold<std::size_t> kPointsOfFacet{224};
inline constinit const Threshold<std::size_t> kFewPointsOfFacet{48};
inline constinit const Threshold<std::size_t> kFewFacets{64};

/// Of such a walk, times n: points of S near the facet that columns are chosen from, columns that are chosen,
/// and basis changes at most; and the share of the highest points along x that is chosen first.
inline constinit const Threshold<int> kListedPoints{50};
inline constinit const Threshold<int> kChosenColumns{8};
inline constinit const Threshold<int> kPivotsOfWalk{12};
inline constinit const Threshold<float> kFirstShare{0.5F};

/// Dimensions from which on weights are looked for before linear programs, which take longer.
inline constinit const Threshold<int> kManyDimensionsOfOrigin{32};

/// Of a streamed set: points so little below the best known ones, relative, are the next to price out.
inline constinit const Threshold<double> kReachOfStream{0.05};

/// Of the tolerance: the gap of a solve of its working sets, and what a point of either set may gain.
inline constinit const Threshold<double> kShareOfStream{0.25};

}  // namespace raygauge::tuned
