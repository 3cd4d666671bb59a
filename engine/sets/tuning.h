// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/numerics/threshold.h"

/// What was found by measurement for support points of many points.
namespace raygauge::tuned {

/// Coordinates of a set from which on a tree of its points may pay.
inline constinit const Threshold<std::ptrdiff_t> kFewestNumbersOfTree{16384};

/// Blocks of points of a leaf.
inline constinit const Threshold<std::ptrdiff_t> kBlocksOfLeaf{8};

/// The share of the points compared from which on a pass over all is as fast: of sets of fewer coordinates
/// than these, which caches hold, and of others.
inline constinit const Threshold<double> kTreePays{0.1};
inline constinit const Threshold<double> kTreePaysBeyondCache{0.4};
inline constinit const Threshold<std::ptrdiff_t> kNumbersBeyondCache{std::ptrdiff_t{1} << 17};

/// Points of a list of the table of directions that is not worth dividing, and the longest: beyond, a pass
/// over all points is as fast.
inline constinit const Threshold<std::int32_t> kShortList{2};
inline constinit const Threshold<std::size_t> kLongestList{24};

/// Cells of that table along an edge of the cube, at most: a power of two.
inline constinit const Threshold<int> kMostCells{32};

/// The ratio of the axes of a set below which mapping it to a round one is not worth the arithmetic.
inline constinit const Threshold<double> kRoundEnough{4};

}  // namespace raygauge::tuned
