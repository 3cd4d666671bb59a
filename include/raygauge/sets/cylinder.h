// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/truncated_cone.h"

namespace raygauge {

/// {x : 0 <= (x - p)·a <= |q - p|, |(x - p)_⊥| <= r}, the cylinder around the segment from p to q, a = (q -
/// p)/|q - p|; in R^n its cross-section is a ball of n - 1 dimensions. r = 0 is a segment.
///
///     h(u) = max(u·p, u·q) + r |u_⊥|,      s(u) = (q where u·(q - p) > 0, else p) + r u_⊥/|u_⊥|,
///     u_⊥ = u - (u·a) a.
class Cylinder final : public Frustum {
 public:
  /// Throws InvalidParameterError (n < 1, p = q, r < 0), DimensionMismatchError or NonFiniteError.
  Cylinder(const ConstVectorRef& p, const ConstVectorRef& q, double radius);

  const Vector& p() const noexcept { return base(); }
  const Vector& q() const noexcept { return top(); }
  double radius() const noexcept { return base_radius(); }
};

}  // namespace raygauge
