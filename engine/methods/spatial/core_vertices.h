// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "raygauge/sets/spatial_shape.h"

namespace raygauge {

/// How many vertices a core has: 0 of a curved one.
std::ptrdiff_t count_core_vertices(const SpatialShape& shape);

/// A vertex without rounding, in the frame of the core; of a curved core its centre.
Vector3 core_vertex(const SpatialShape& shape, std::int32_t index);

}  // namespace raygauge
