// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "raygauge/sets/convex_set.h"

namespace raygauge::cli {

/// The mesh of a file, taken `as` "hull" (the convex hull of its vertices, a PointSet), "surface" or "solid"
/// (a MeshObject). Throws what read_mesh and the constructor of Mesh throw, with the name of the file, and
/// UnknownNameError for another word.
std::shared_ptr<const ConvexSet> read_mesh_as(const std::string& path, const std::string& as);

}  // namespace raygauge::cli
