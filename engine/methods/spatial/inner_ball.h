// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/precise_pair.h"

namespace raygauge {

/// The radius of a ball about `center` inside D, proven, as far as double-double arithmetic can; 0 where it
/// proves none: where the centre is outside or within rounding errors of the boundary. Once it is `enough`
/// the search ends.
///
/// From a point c inside D, which is taken at random so that the ray from c to the centre passes no edge and
/// no corner, three support points whose cone about c holds the centre are exchanged for ones farther out (as
/// in spatial_growth), until the tetrahedron of c and of them holds the centre. So it does not matter how the
/// centre lies to the faces that other steps met: on one of them, on an edge, or at a corner.
double inner_ball(const SpatialPair& pair, PrecisePair& precise, const PreciseVector3& center, double enough);

}  // namespace raygauge
