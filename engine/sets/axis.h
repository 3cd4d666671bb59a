// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/sets/convex_set.h"

namespace raygauge {

/// The axis of a body of revolution in R^n: a unit vector a, along which any u splits into (u·a) a + u_⊥.
class Axis {
 public:
  /// From p to q. Throws DimensionMismatchError, NonFiniteError or, for p = q, InvalidParameterError; `set`
  /// is the body in the messages.
  Axis(const std::string& set, const ConstVectorRef& p, const ConstVectorRef& q);

  /// |u_⊥|, and u_⊥/|u_⊥| in `radial` (zero where u_⊥ = 0), orthogonal to the axis to rounding even for u
  /// along it, where u_⊥ itself is nothing but rounding.
  double radial_part(const double* u, double* radial) const noexcept;

  const Vector& direction() const noexcept { return direction_; }

 private:
  Vector direction_;
};

}  // namespace raygauge
