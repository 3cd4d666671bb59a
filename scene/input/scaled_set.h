// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/input/shapes.h"

namespace raygauge::cli {

inline constexpr double kLargestScale = 1e300;

/// {scale x : x in the set}, with |scale| <= kLargestScale: of the same class where that has a scale, a mesh,
/// a point set and a half-space, and an affine image of others.
SetPointer scaled(const SetPointer& set, double scale);

}  // namespace raygauge::cli
