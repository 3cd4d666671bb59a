// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/precise_pair.h"
#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// Goes on where spatial_distance ended `open` because rounding hides what is left: bodies that touch, or are
/// 1e-9 of their size apart. The same steps in double-double arithmetic, from the support points or the
/// normal of `answer`; usually one of them proves it. The directions of the lower bound are normals of
/// triangles, or are made orthogonal to an edge: computed from v they would be no more precise than v is.
/// `answer` is brought up to date, and stays open where even this does not do.
void precise_distance(const SpatialPair& pair, double tolerance, SpatialAnswer& answer);

}  // namespace raygauge
