// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace raygauge
