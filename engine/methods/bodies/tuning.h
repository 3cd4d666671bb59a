// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/threshold.h"

/// What was found by measurement for depths of pairs of bodies.
namespace raygauge::tuned {

/// Share of the tolerance that distances of cores apart are asked for again, where the first was too coarse.
inline constinit const Threshold<double> kShareOfCores{0.8};

/// Steps of a search after which the polytope that it has begun from is recorded anew: fewer serve bodies at
/// rest, more serve those that move.
inline constinit const Threshold<int> kStepsWorthRecording{3};

/// Corners of a polytope that is recorded for the next solve, at most 256, and their number over that of the
/// last one that was made anew.
inline constinit const Threshold<int> kCornersWorthRecording{127};
inline constinit const Threshold<double> kGrownPolytope{1.25};

/// Of the noise: by how much n·s may differ over a facet of R^4 to R^6 before its normal is computed from its
/// corners. Errors of normals that come from their neighbours' add up.
inline constinit const Threshold<double> kUnevenFacet{64};

}  // namespace raygauge::tuned
