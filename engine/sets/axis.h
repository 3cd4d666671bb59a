// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The axis of a body of revolution in R^n: a unit vector a, along which any u splits into (u·a) a + u_⊥.
class Axis {
 public:
  /// From p to q. Throws DimensionMismatchError, NonFiniteError or, for p = q, InvalidParameterError; `set`
  /// is the body in the messages.
  Axis(const std::string& set, const ConstVectorRef& p, const ConstVectorRef& q);

  /// |u_⊥|, and u_⊥/|u_⊥| in `radial` (zero where u_⊥ = 0), orthogonal to the axis to rounding even for u
  /// along it, where u_⊥ itself is nothing but rounding.
  template <class Real>
  Real radial_part(const Real* u, Real* radial) const noexcept;

  const Vector& direction() const noexcept { return direction_; }

  /// a, n numbers, in double or in quadruple precision.
  template <class Real>
  const Real* components() const noexcept;

 private:
  Vector direction_;
  std::vector<Quad> quad_direction_;
};

}  // namespace raygauge
