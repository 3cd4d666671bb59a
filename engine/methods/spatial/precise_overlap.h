// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/precise_pair.h"

namespace raygauge {

/// Proves that the origin is in D, deeper than the rounding errors of double-double arithmetic. From a point
/// c inside D, which is taken at random so that the ray from c to the origin passes no edge and no corner,
/// three support points whose cone about c holds the origin are exchanged for ones farther out (as in
/// spatial_growth), until the tetrahedron of c and of them holds the origin. So it does not matter how the
/// origin lies to the faces that other steps met: on one of them, on an edge, or at a corner.
///
/// False where this proves nothing: where the origin is outside or within rounding errors of the boundary.
bool precise_overlap(const SpatialPair& pair, PrecisePair& precise);

}  // namespace raygauge
