// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// Eight triangles, one to a lane, as structure of arrays.
struct alignas(64) FacetLanes {
  static constexpr int kCount = 8;
  using Row = double[kCount];

  Row corner[3][3] = {};  ///< [c][k]: coordinate k of corner c; any numbers in lanes that are not used

  /// Out: what InnerPolytope says of a facet.
  Row n[3], reach, offset;
};

/// What InnerPolytope<double>::measure does, of all lanes, for corners of length at most `size`; the same
/// bits whatever the machine.
void measure_facets(double size, FacetLanes& lanes);

/// The same of the facets from corner i to corner i + 1 and to `apex`; there are kCount + 1 corners.
void measure_fan_of_facets(double size, const Vector3* const* corner, const Vector3& apex, FacetLanes& lanes);

}  // namespace raygauge
