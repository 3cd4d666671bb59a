// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/numerics/real.h"

namespace raygauge {

/// Three points s_l of a convex set that holds the origin, the corners a, b and c. Minkowski portal
/// refinement moves them outward as long as their cone holds a point p, in either arithmetic. `Corner` may be
/// a reference to a corner that outlives the portal.
template <class Real, class Corner = BasicVector3<Real>>
struct Portal {
  using Vector = BasicVector3<Real>;

  Corner a, b, c;

  Real determinant() const { return dot(cross(a, b), c); }

  /// Whether the cone of the corners holds p. The determinant is not negative.
  bool holds(const Vector& p) const {
    return high(dot(p, cross(a, b))) >= 0 && high(dot(p, cross(b, c))) >= 0 && high(dot(p, cross(c, a))) >= 0;
  }

  /// The corner that makes room for a new point w: the one without which the cone still holds p.
  int leaving(const Vector& p, const Vector& w) const {
    const double of_a = high(dot(p, cross(w, a))), of_b = high(dot(p, cross(w, b))),
                 of_c = high(dot(p, cross(w, c)));
    if (of_b >= 0 && of_c <= 0) return 0;
    return of_c >= 0 && of_a <= 0 ? 1 : 2;
  }

  /// A normal n of the corners' plane, of any length, on the side of p, and n·p.
  Vector normal(const Vector& p, Real& along) const {
    Vector n = cross(b - a, c - a);
    along = dot(n, p);
    if (high(along) < 0) n = -n, along = -along;
    return n;
  }

  /// The weights with p = Σ weight_l s_l. False where the portal is in a plane with the origin.
  bool weigh(const Vector& p, Real* weight) const {
    const Vector n = cross(b, c);
    const Real size = dot(n, a);
    if (!(std::fabs(high(size)) > 0)) return false;
    const Real share = Real{1} / size;
    weight[0] = dot(n, p) * share;
    weight[1] = dot(cross(c, a), p) * share;
    weight[2] = dot(cross(a, b), p) * share;
    return true;
  }

  /// At least the sum of the exact weights, for corners and p each within `error` of the computed ones; where
  /// one of the weights may be negative, infinity. The exact inverse of the portal differs from the computed
  /// one by a share of error times its norm, which must be small. With S the matrix of the corners,
  ///
  ///     |weight - computed weight| <= δ = 2 |S⁻¹| (|p - Σ weight_l s_l| + error).
  double sum_of_weights(const Vector& p, const Real* weight, double error) const {
    constexpr double kUp = 1 + 0x1p-48;  // of a few operations on numbers that are certain otherwise
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    const double size = std::fabs(high(determinant()));
    const double norm =
        length_of(cross(b, c)) / size + length_of(cross(c, a)) / size + length_of(cross(a, b)) / size;
    if (!(8 * norm * error < 0.25)) return kUnknown;
    const Vector r = p - a * weight[0] - b * weight[1] - c * weight[2];
    const double total = rounded(weight[0] + weight[1] + weight[2]);
    const double uncertainty = 2 * norm * (length_of(r) + 4 * error * (1 + std::fabs(total)));
    const double least = std::min({rounded(weight[0]), rounded(weight[1]), rounded(weight[2])});
    return least >= uncertainty ? (total + 3 * uncertainty) * kUp : kUnknown;
  }
};

}  // namespace raygauge
