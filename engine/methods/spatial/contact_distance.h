// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// Goes on where spatial_distance left two near bodies, one of them with a curved core: there the direction
/// v/|v| of its steps is lost in rounding, but the normal u that minimizes h_D over the unit sphere is not.
/// Newton steps on that, with the pieces l of the cores (vertices, rims, ellipsoids) whose points s_l follow
/// u,
///
///     min over d ⊥ u of  max_l (u·s_l + d·s_l) + d·(H + λ)d/2,      H the Hessian of Σ c_l u·s_l,
///
/// λ the distance; the multipliers c_l prove the upper bound |Σ c_l s_l|, as ever. Where u comes near the
/// axis of a frustum, the disc is tried: if the point of it below the other body's support point is inside,
/// the axis is that normal.
///
/// Ends `closed` where doubles prove enough, and `intersecting` where a point of one core is inside the other
/// one for certain; otherwise the hint and the combination of `answer` are where precise_distance goes on
/// from.
void contact_distance(SpatialPair& pair, double tolerance, SpatialAnswer& answer);

}  // namespace raygauge
