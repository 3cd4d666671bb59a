// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/input/hull_note.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge::cli {

/// The mesh of a file, taken `as` "hull" (the convex hull of its vertices, a PointSet), "surface" or "solid"
/// (a MeshObject). Throws what read_mesh and the constructor of Mesh throw, with the name of the file, and
/// UnknownNameError for another word.
std::shared_ptr<const ConvexSet> read_mesh_as(const std::string& path, const std::string& as);

/// The points that `source` names (see read_point_source), those of meshes and PCD files too, as the cloud of
/// balls about them (a MeshObject). Throws what read_point_source and Mesh::cloud throw.
std::shared_ptr<const ConvexSet> read_cloud(const std::string& source, double radius);

/// The mesh of a file as it is: its hull where it is convex (see hull_cost) or has no faces, else a solid
/// where its surface is closed, else that surface. A note names the last two, and the way to the hull.
std::shared_ptr<const ConvexSet> read_mesh_as_it_is(const std::string& path, Notes& notes);

/// Convex parts as programs for convex decomposition write them, each the hull of
///   - a mesh of a folder, in the order of names, if the only source is one;
///   - an object of an OBJ file (`o`, or else `g`), of the vertices that its faces use, if the only source is
///     one; runs of the same name are one object;
///   - a mesh of a list of files.
/// Notes say how many there are and which mesh is not convex. Throws what read_mesh throws, EmptySetError for
/// a folder without meshes, InvalidParameterError for a file without two objects.
std::vector<std::shared_ptr<const ConvexSet>> read_parts(const std::vector<std::string>& sources,
                                                         Notes& notes);

}  // namespace raygauge::cli
