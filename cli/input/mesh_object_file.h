// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/input/hull_note.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge::cli {

/// What is made of the mesh of a file that is called `name` in notes and errors, taken `as`
///   - "": as it is: its hull where it is convex (see hull_cost) or has no faces, else a solid where its
///     surface is closed, else that surface;
///   - "hull": the convex hull of its vertices, a PointSet;
///   - "surface", "solid": a MeshObject;
///   - "parts": convex parts, each the hull of an object of an OBJ file (`o`, or else `g`), of the vertices
///   that
///     its faces use; runs of the same name are one object.
/// Notes say what a mesh that is not convex is taken for and what to write for another choice, how many parts
/// there are, and which objects have no faces. Throws what the constructor of Mesh throws,
/// InvalidParameterError for "parts" of a file without two objects, UnknownNameError for another word.
std::vector<std::shared_ptr<const ConvexSet>> take_mesh(const MeshFile& file, const std::string& name,
                                                        const std::string& as, Notes& notes);

/// Throws UnknownNameError, which begins with `what`, unless take_mesh has such a way.
void check_way_to_take_a_mesh(const std::string& as, const std::string& what, const std::string& place);

/// Whether "parts" has parts to take.
bool has_objects(const MeshFile& file);

/// The mesh of a file, taken `as` "hull", "surface" or "solid".
std::shared_ptr<const ConvexSet> read_mesh_as(const std::string& path, const std::string& as);

/// The points that `source` names (see read_point_source), those of meshes and PCD files too, as the cloud of
/// balls about them (a MeshObject). Throws what read_point_source and Mesh::cloud throw.
std::shared_ptr<const ConvexSet> read_cloud(const std::string& source, double radius);

/// Convex parts as programs for convex decomposition write them: those of an OBJ file, if it is the only
/// source, or the hulls of the meshes of a folder, in the order of names, or of a list of files. Throws what
/// read_mesh and take_mesh throw, EmptySetError for a folder without meshes.
std::vector<std::shared_ptr<const ConvexSet>> read_parts(const std::vector<std::string>& sources,
                                                         Notes& notes);

}  // namespace raygauge::cli
