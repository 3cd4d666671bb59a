// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "engine/numerics/threshold.h"

/// What was found by measurement for trees of triangles.
namespace raygauge::tuned {

/// Triangles of a box at most that may lie along the surface.
inline constinit const Threshold<std::ptrdiff_t> kOrientedTriangles{512};

/// Triangles of a box at most that is cut where it is best, not in the middle.
inline constinit const Threshold<std::ptrdiff_t> kSearchedTriangles{1024};

}  // namespace raygauge::tuned
