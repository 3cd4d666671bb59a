// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/spatial_shape.h"

namespace raygauge {

/// A vertex none of whose neighbours is higher along v, reached by steps to the highest neighbour, from the
/// vertex `from`, or from the table of directions where that is no vertex. On a convex polytope it is the
/// highest of all but for rounding errors, which flat faces may add up: only a pass over all points proves
/// it.
std::int32_t climb(const HullGraph& graph, const Vector3& v, std::int32_t from) noexcept;

/// The cell of the table that v belongs to.
int direction_cell(const Vector3& v, int cells) noexcept;

}  // namespace raygauge
