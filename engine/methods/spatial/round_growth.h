// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/growth_bounds.h"

namespace raygauge {

/// The growth distance of bodies with balls or curved surfaces, from a start; true where the solve is done.
/// The best direction is in the answer otherwise.
///
/// Polytopes K with balls of the radius ρ in all: x = t p, from outside, comes to where it is ρ away from K
/// by GJK steps; the normal there, u, proves t <= (h_K(u) + ρ)/u·p, from where the next step goes on (van den
/// Bergen, Ray Casting against General Convex Objects, 2004). The ball of radius ρ about the point of K that
/// x is nearest to bounds σ from above. Others: Newton steps  H δ = p/σ - s(u), δ ⊥ u,  on the condition s(u)
/// ∥ p; there the ball that rolls inside B, where one does, touches it at s(u).
bool round_growth(SpatialPair& pair, double tolerance, double threshold, const SpatialStart& start,
                  SpatialAnswer& answer);

/// Newton steps on the unit sphere from the direction u. True where the solve is done; the best direction is
/// in the answer otherwise. `fine_normal`: as in SpatialStart.
bool newton_growth(GrowthBounds& growth, Vector3 u, bool fine_normal);

}  // namespace raygauge
