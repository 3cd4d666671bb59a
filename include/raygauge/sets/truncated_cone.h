// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/frustum.h"

namespace raygauge {

/// conv(D_b ∪ D_t), D_i = {x : |x - p_i| <= r_i, (x - p_i)·a = 0}: the truncated cone between two discs
/// across the axis a = (p_t - p_b)/|p_t - p_b|; in R^n the discs are balls of n - 1 dimensions. r_t = 0 is a
/// cone, r_t = r_b a cylinder, r_t > r_b an inverted cone, both 0 a segment.
///
///     h(u) = max_i (u·p_i + r_i |u_⊥|),      s(u) = p_i + r_i u_⊥/|u_⊥|,      u_⊥ = u - (u·a) a.
class TruncatedCone final : public Frustum {
 public:
  /// Throws InvalidParameterError (n < 1, p_b = p_t, a negative radius), DimensionMismatchError or
  /// NonFiniteError.
  TruncatedCone(const ConstVectorRef& base, double base_radius, const ConstVectorRef& top, double top_radius);
};

}  // namespace raygauge
