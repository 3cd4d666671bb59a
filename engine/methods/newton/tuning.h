// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/threshold.h"

/// What was found by measurement for Newton's method on smooth sets.
namespace raygauge::tuned {

/// The tangent of the angle that one step may turn u by.
inline constinit const Threshold<double> kLongestNewtonStep{1.0};

/// What a step that does not rise is shortened to.
inline constinit const Threshold<double> kShorterNewtonStep{0.4};

}  // namespace raygauge::tuned
