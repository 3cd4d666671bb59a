// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_distance.h"

namespace raygauge {

/// Reduces the combination to the face of its simplex that is nearest to the origin, with the weights of the
/// nearest point v, which is returned. A simplex that contains the origin stays whole: then `depth` is the
/// distance of the origin to its nearest face, otherwise zero.
Vector3 nearest_on_simplex(SpatialCombination& simplex, double& depth);

}  // namespace raygauge
