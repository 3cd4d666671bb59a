// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// The point nearest to p of a core in its own frame: of a point, segment, box or frustum. False for the
/// others.
bool nearest_in_core(const SpatialShape& shape, const Vector3& p, Vector3& nearest);

/// The Euclidean distance of a ball and a body whose core has a formula (nearest_in_core), and of two
/// capsules: with a1, a2 the nearest points of the cores and u the direction between them, bounded as in
/// spatial_distance(). False, and nothing is said, where the cores have no formula, overlap, or where
/// rounding leaves a wider gap.
bool closed_form_distance(SpatialPair& pair, double tolerance, SpatialAnswer& answer);

}  // namespace raygauge
