// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/precise_pair.h"
#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// Goes on where spatial_growth ended `open` on two bodies about their centres: needles a million times as
/// long as thick, for which the rounding errors of doubles are too large a share of the thickness. With three
/// different vertices or rims, those of its portal: the same exchanges and bounds in double-double
/// arithmetic, the points of rims and balls being those for the portal's normal. The exact weights are
/// enclosed:
///
///     σ <= Σ c_l + 3 δ,   c_l >= δ,      δ = 2 |S⁻¹| (|p - Σ c_l s_l| + error).
///
/// For others without balls by Newton steps from its normal u, with the one support point s there and R the
/// radius of a ball inside B: σ <= c + (|p - c s| + error)/R with c = u·p / h_B(u), the lower bound.
///
/// `answer` stays as it was where this does not do.
void precise_growth(const SpatialPair& pair, double tolerance, SpatialAnswer& answer);

}  // namespace raygauge
