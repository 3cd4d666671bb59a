// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "generators/random.h"

namespace raygauge {

/// c + factor · K for a convex body K with 0 in its interior: a function of the centre c and the factor,
/// which may be negative.
using Homothet = std::function<std::shared_ptr<const ConvexSet>(const Vector& center, double factor)>;

/// The parameter `object`: what A is. `homothet`: c - r K; `point`: {c}; `around_origin`: c - r K with 0
/// inside.
ParameterInfo object_parameter();

/// Two homothets of K and their distance:
///
///     A = t p - r K,      Q = s K,      d = max(0, t gauge_K(p) - r)/s,
///
/// 8 <= t <= 16 a random integer, r a random integer from 1 to ¾ t gauge (0 for a point, above t gauge for
/// 0 in A), s in {¼, ½, 1, 2, 4}. d is exact where the quotient is a double, else correctly rounded as far as
/// `gauge` = gauge_K(p) is.
Instance homothets(RandomStream& stream, const Parameters& parameters, const Homothet& K, const Vector& p,
                   long double gauge = 1);

}  // namespace raygauge
