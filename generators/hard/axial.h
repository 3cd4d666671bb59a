// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// Bodies of revolution about an axis through 0, in a random orientation that rounds nothing (HalfPlane of
// similarities.h), and their homothets (homothets.h): c lies on the ray through a point p of K's surface, so
// that gauge_K(p) = 1. n >= 2, N is ignored. Heights z along the axis and distances ρ from it are in units of
// the half plane.

/// `hard_truncated_cone`: K between discs at heights -z_b and z_t, gauge max(z/z_t, -z/z_b, (ρ + kz)/R) with
/// R the radius at 0 and k the slope. `shape`: truncated (k = 1), cone (top radius 0), cylinder (k = 0),
/// inverted (k = -1). `place` of p: on the side, inside the base disc (cap), on its rim, or on the axis,
/// where the radial direction is 0/0. d = (t - r)/s exactly.
Component<Generator> hard_truncated_cone_generator();

/// `hard_capsule`: K = the points within 5 of a segment of half-length 5 · `ratio`, rounded to a multiple of
/// 2^-10. `place` of p: on the side, on the cap, on the seam of the two, or at the tip on the axis. d = (t -
/// r)/s exactly. At ratio 1 the quadratic equation that the gauge solves on the caps is linear.
Component<Generator> hard_capsule_generator();

/// `hard_near_axis`: p at distance δ from the axis of a `body`, δ = `delta` rounded to a multiple of 2^-36.
/// d = (t gauge_K(p) - r)/s with
///
///     cone of heights ∓h, top radius 0     p = (h, δ)      gauge = 1 + δ/h      (the radius at 0 is h)
///     cylinder of heights ∓h, radius 1     p = (h, δ)      gauge = 1
///     capsule of half-length and radius h  p = (2h, δ)     gauge = 1 + (δ/2h)²
///
/// h in {1, 2}: exact, but for the capsule, whose d is one of the two doubles beside it.
Component<Generator> hard_near_axis_generator();

}  // namespace raygauge
