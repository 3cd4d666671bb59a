// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/scene/scene.h"

namespace raygauge::cli {

/// What a page needs to draw a scene, as JSON: the surface of every part as triangles (a polygon in the
/// plane; support_mesh.h), and where every body is at up to some hundred of the instants. "" for scenes of
/// more than 3 dimensions.
std::string drawing_of(const Scene& scene);

}  // namespace raygauge::cli
