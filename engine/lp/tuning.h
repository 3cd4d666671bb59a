// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/numerics/threshold.h"

/// What was found by measurement for the linear programs.
namespace raygauge::tuned {

/// Coordinates of a pass from which on a second thread may pay, and from which on a helper that sleeps is
/// woken for them.
inline constinit const Threshold<std::ptrdiff_t> kSharedNumbers{std::ptrdiff_t{1} << 15};
inline constinit const Threshold<std::ptrdiff_t> kNumbersWorthWaking{std::ptrdiff_t{1} << 17};

/// Coordinates of a chunk of such a pass.
inline constinit const Threshold<std::ptrdiff_t> kNumbersOfChunk{std::ptrdiff_t{1} << 14};

/// A sample of a set has √(n N) points over this, ...
inline constinit const Threshold<double> kSampleDivisor{2};

/// ... and at least so many blocks of points: of fewer than 5 dimensions, and of more.
inline constinit const Threshold<std::ptrdiff_t> kLeastSampleInFew{16};
inline constinit const Threshold<std::ptrdiff_t> kLeastSampleInMore{8};

/// Dimensions from which on that would be fewer points than make a basis, or little more, which is another
/// problem: it has at least so many points for each dimension instead.
inline constinit const Threshold<int> kManyDimensionsOfSample{48};
inline constinit const Threshold<std::ptrdiff_t> kSampleOverDimension{4};

/// Coordinates of a set in many dimensions from which on a sample is worth its passes.
inline constinit const Threshold<std::ptrdiff_t> kWorthSampling{std::ptrdiff_t{1} << 15};

/// Coordinates of a sample from which on pricing it in single precision saves more than making the copy
/// takes.
inline constinit const Threshold<std::ptrdiff_t> kWorthRounding{8192};

/// Points of both sets for each dimension from which on the interior-point method takes Q to reach A.
inline constinit const Threshold<std::ptrdiff_t> kManyPointsInside{4};

/// Columns that weigh less than this share of the (n + 1)st heaviest are left out of its matrix.
inline constinit const Threshold<double> kNegligibleColumns{1e-3};

/// Products x·s per unit of t down to which it multiplies in single precision.
inline constinit const Threshold<double> kCoarseProducts{1e-3};

/// Corrections of a step at most, and the gain in length that one is worth.
inline constinit const Threshold<int> kCorrectionsOfStep{4};
inline constinit const Threshold<double> kWorthCorrecting{0.05};

}  // namespace raygauge::tuned
