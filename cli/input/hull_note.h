// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/input/mesh_file.h"
#include "engine/meshes/convexity.h"

namespace raygauge::cli {

/// Lines about what was read, each said once.
using Notes = std::vector<std::string>;

/// That the hull of a mesh which is not convex stands for it, and by how much it is larger; "" for a mesh
/// that is convex (see hull_cost), and for points without faces.
std::string hull_note(const std::string& name, const MeshFile& mesh);

/// ": the hull has … of volume, the mesh …", or that the surface is open; "" where neither is known.
std::string volumes_of(const HullCost& cost);

/// Adds a note that is not "" and not there.
void add_note(const std::string& note, Notes& notes);

/// On standard error, "note: …".
void print_notes(const Notes& notes);

}  // namespace raygauge::cli
