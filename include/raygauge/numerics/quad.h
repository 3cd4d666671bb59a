// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace raygauge {

/// Quadruple precision (IEEE binary128, 113 bits) where the compiler has it, else the longest floating-point
/// type there is. Evaluated in software: a hundred times slower than a double.
#ifdef __SIZEOF_FLOAT128__
__extension__ using Quad = __float128;
#else
using Quad = long double;
#endif

/// Half the distance from 1 to the next number of a type: one rounded operation is off by at most this
/// relative to its result. For Quad it includes a safety factor of 16 for elementary functions.
template <class Real>
inline constexpr double kRoundoff = std::numeric_limits<double>::epsilon() / 2;

#ifdef __SIZEOF_FLOAT128__
template <>
inline constexpr double kRoundoff<Quad> = 0x1p-109;
#else
template <>
inline constexpr double kRoundoff<Quad> = 8 * std::numeric_limits<long double>::epsilon();
#endif

/// The elementary functions that support functions are made of, by one name for either precision.
namespace elementary {

inline double sqrt(double x) noexcept { return std::sqrt(x); }
inline double fabs(double x) noexcept { return std::fabs(x); }
inline double pow(double x, double y) noexcept { return std::pow(x, y); }
inline double copysign(double x, double y) noexcept { return std::copysign(x, y); }

inline Quad fabs(Quad x) noexcept { return x < 0 ? -x : x; }
inline Quad copysign(Quad x, Quad y) noexcept { return (x < 0) == (y < 0) ? x : -x; }
Quad sqrt(Quad x) noexcept;
Quad pow(Quad x, Quad y) noexcept;

}  // namespace elementary
}  // namespace raygauge
