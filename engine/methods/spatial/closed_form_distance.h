// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// The Euclidean distance of a ball and a body whose core has a formula for its nearest point, and of two
/// capsules: with a1, a2 the nearest points of the cores and u the direction between them, bounded as in
/// spatial_distance(). False, and nothing is said, where the cores have no formula, overlap, or where
/// rounding leaves a wider gap.
bool closed_form_distance(SpatialPair& pair, double tolerance, SpatialAnswer& answer);

}  // namespace raygauge
