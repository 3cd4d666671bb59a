// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// Proves that the origin is in D, the difference of two cores with vertices, although it is nearer to the
/// boundary of D than the rounding errors of doubles. `face` has 1 to 3 vertices of D, and v, next to the
/// origin, is an affine combination of them, known to `v_error`. Vertices in the direction of -v are added
/// until they are four. The facets that hold v have the origin on their inner side if  n·v > 0,  n the
/// outer normal: in doubles n is off by a small share, and so is n·v, as v is short. The other facets are
/// farther from the origin than rounding errors.
///
/// False where this proves nothing, as it must for an origin outside; `face` then has the vertices, at most
/// three, from which no other one was clearly nearer to the origin, the added ones with the weight 0.
bool slight_overlap(SpatialPair& pair, SpatialCombination& face, const Vector3& v, double v_error);

}  // namespace raygauge
