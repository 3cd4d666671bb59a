// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// The growth distance of two bodies about their centres: with p from the first centre to the second and
/// B = D + p = (S1 - c_1) - (S2 - c_2),
///
///     σ = gauge_B(p) = max_u u·p / h_B(u).
///
/// Three support points whose cone holds p are exchanged, one at a time, for the support point across their
/// plane (the simplex method on 3 × 3 bases, as in Minkowski portal refinement). The first three are found
/// near the ray of p, by normals tilted towards it, as much as a ball asks for, or a plate where both bodies
/// are needles. Bodies that are round begin as round_growth() says. The bounds at any time:
///
///     u·p / h_B(u) <= σ <= Σ c_l + (|p - Σ c_l s_l| + error)/R,      R the radius of a ball about 0 inside
///     B, and σ <= 1/t, t p where the ray of p leaves another ball inside B;
///
/// without a known R the exact weights are enclosed instead: where all of them are positive, they prove the
/// bound. The solve ends early (`separated`, `intersecting`) when `threshold` is outside the bounds; NaN:
/// never.
void spatial_growth(SpatialPair& pair, double tolerance, double threshold, const SpatialStart& start,
                    SpatialAnswer& answer);

}  // namespace raygauge
