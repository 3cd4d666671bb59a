// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/numerics/threshold.h"

/// What was found by measurement for pairs of bodies in R^2 and R^3.
namespace raygauge::tuned {

/// Radians that a step of Newton's method for the distance may turn the normal by, and what that is
/// multiplied by after a step that does not rise, and after one that does.
inline constinit const Threshold<double> kLongestContactStep{0.5};
inline constinit const Threshold<double> kShorterContactStep{0.3};
inline constinit const Threshold<double> kLongerContactStep{2};

/// Of the size of a pair: bounds of GJK so near the surfaces of curved bodies leave the rest to those steps.
inline constinit const Threshold<double> kNearCurved{3e-2};

/// The same of hulls, which the portal takes over, and where they are so near that GJK goes on.
inline constinit const Threshold<double> kNearFacets{0.1};
inline constinit const Threshold<double> kTouchingFacets{1e-6};

/// Points of two hulls whose facets GJK finds as fast as the portal does; and where it begins near them.
inline constinit const Threshold<std::ptrdiff_t> kFewPointsOfHulls{300};
inline constinit const Threshold<std::ptrdiff_t> kFewPointsFromStart{3000};

/// Radians that a step of Newton's method for the growth distance may turn the normal by.
inline constinit const Threshold<double> kLongestGrowthStep{0.7};

/// Shares of the angle that would do for a ball, by which the first portal is tilted.
inline constinit const Threshold<double> kFirstTilt{1.7};

}  // namespace raygauge::tuned
