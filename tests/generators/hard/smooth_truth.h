// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// 100 decimal digits.
using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

/// d_Q(A) of the numbers that the sets hold, from the definition of the gauge of Q, whatever a generator
/// meant them to be: Q a ball that touches the origin and A a point, or Q a p-norm ball, ellipsoid, truncated
/// cone, cylinder or capsule about the origin and A a point or, which is checked, a homothet c - fQ:
///
///     d = max(0, gauge_Q(c) - f).
///
/// Throws std::logic_error if the sets are not such a pair.
Real smooth_distance(const ConvexSet& A, const ConvexSet& Q);

}  // namespace raygauge
