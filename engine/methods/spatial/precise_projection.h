// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/precise_pair.h"

namespace raygauge {

/// Whether the core has nearest_in_core below: boxes and frustums.
bool has_projection(const SpatialShape& shape);

/// The point of the core of `shape` nearest to y, all in its own frame; y itself inside.
PreciseVector3 nearest_in_core(const SpatialShape& shape, const PreciseVector3& y);

}  // namespace raygauge
