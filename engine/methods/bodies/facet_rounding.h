// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/real.h"

namespace raygauge {

/// What a scalar product of a unit vector may lose, relative to the other factor.
template <class Real>
inline constexpr double kFacetProduct = 8 * kUnitOf<Real>;

/// What the normal of a triangle may lose, relative to the product of its two shorter edges: 16 rounding
/// units, and one for the test of that.
template <class Real>
inline constexpr double kFacetEdges = 17 * kUnitOf<Real>;

/// Normals of triangles that are shorter have lost digits to underflow.
inline constexpr double kLeastFacetNormal = 1e-150;

}  // namespace raygauge
