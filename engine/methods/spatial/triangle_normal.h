// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/real.h"

namespace raygauge {

/// A normal of the triangle, from the two shorter of its edges, where cancellation is least.
template <class Real>
inline BasicVector3<Real> triangle_normal(const BasicVector3<Real>& a, const BasicVector3<Real>& b,
                                          const BasicVector3<Real>& c) {
  const BasicVector3<Real> ab = b - a, bc = c - b, ca = a - c;
  const Real l = dot(ab, ab), m = dot(bc, bc), k = dot(ca, ca);
  if (l >= m && l >= k) return cross(bc, ca);
  return m >= k ? cross(ca, ab) : cross(ab, bc);
}

}  // namespace raygauge
