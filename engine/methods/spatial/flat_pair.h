// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_pair.h"

namespace raygauge {

/// Makes a prism of D where it is flat: where it lies in a plane or a line through the origin, as polygons in
/// a common plane have it, or is the origin. That must hold for the very numbers of the vertices and the
/// poses, and for the centres where a growth distance is about them: it is decided by exact sums for normals
/// that are doubles, such as those of small integers. False, and D is as before, where it is not flat in this
/// sense, or the bodies are not made of vertices alone.
bool make_prism_of_flat(SpatialPair& pair, bool with_centers);

}  // namespace raygauge
