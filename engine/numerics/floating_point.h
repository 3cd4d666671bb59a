// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace raygauge {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// u = 2⁻⁵³: one rounded operation is off by at most u relative to its result.
inline constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

/// What any number of operations in practice (fewer than 2⁵²) lose below the normal range: each at most
/// 2⁻¹⁰⁷⁵. Itself a normal number: one operation on a subnormal takes as long as a hundred others.
inline constexpr double kUnderflow = std::numeric_limits<double>::min();

}  // namespace raygauge
