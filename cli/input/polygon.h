// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cli/input/mesh_formats.h"

namespace raygauge::cli {

/// Three vertices, in the turn of the polygon that they are of.
using Triangle = std::array<std::int32_t, 3>;

/// Cuts a polygon, in a plane or nearly, into triangles that are added to `triangles`: from its first corner
/// where it is convex, else ear by ear. One of more than kMostEars corners that is not convex is cut from its
/// first corner, too. Polygons of fewer than three corners have none.
void cut_polygon(const std::vector<Vertex>& vertices, std::span<const std::uint32_t> corners,
                 std::vector<Triangle>& triangles);

inline constexpr std::size_t kMostEars = 2000;

}  // namespace raygauge::cli
