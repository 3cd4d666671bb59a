// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/instance.h"

namespace raygauge {

// Families without a closed form: the exact distance is that of the points as rounded to doubles, which an
// exact rational linear program finds. exact_distance is left empty.

/// `hard_moment_curve`: N points of the moment curve γ(t) = (t, t², …, t^n), t uniform on [-1, 1], in each
/// set; those of Q less their mean, those of A moved by twice a random unit vector. Bases are
/// ill-conditioned.
Component<Generator> hard_moment_curve_generator();

/// `hard_polygons`: two regular N-gons of radius 1, one about 0, the other turned by half an edge, about a
/// centre 2 · separation away: facets are nearly parallel. For n > 2 both are bipyramids over them, with
/// apexes at ±1 on the further axes, which leaves d as it is. N >= 3, n >= 2.
Component<Generator> hard_polygons_generator();

/// `hard_minkowski_difference`: A = {p_i - q_j}, as rounded, of two clouds of ⌊√N⌋ points on unit spheres
/// whose centres are 4 apart, both `offset` away from the origin; Q is the cross-polytope.
Component<Generator> hard_minkowski_difference_generator();

/// `hard_low_rank`: A is N integer points of a random flat of dimension `rank` (0: one point N times, 1: a
/// segment, …); Q is the cross-polytope together with N points of the unit sphere.
Component<Generator> hard_low_rank_generator();

}  // namespace raygauge
