// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace raygauge {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// u = 2⁻⁵³: one rounded operation is off by at most u relative to its result.
inline constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

}  // namespace raygauge
