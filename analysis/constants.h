// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace raygauge {

/// The time of a solve that came to no answer; a bound that says nothing.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// What is unknown.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace raygauge
