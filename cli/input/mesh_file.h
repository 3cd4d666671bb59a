// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cli/input/polygon.h"

namespace raygauge::cli {

/// Whether the name ends as a mesh's does: .obj, .off, .stl, .ply, .dae, .glb, .gltf or .pcd, in any case,
/// also with .gz behind it.
bool is_mesh_file(const std::string& path);

/// An object of a file, or a group: triangles [begin, end).
struct MeshRun {
  std::string name;
  std::size_t begin = 0, end = 0;
};

/// What a mesh file holds: vertices in the order of the file, 3 × N, and its faces cut into triangles.
struct MeshFile {
  Eigen::Matrix3Xd vertices;
  std::vector<Triangle> triangles;
  std::vector<MeshRun> runs = {};  ///< of a file with objects: all triangles, in order
};

/// Every digit counts, in the axes and the unit of the file (docs/meshes.md). Throws InvalidParameterError,
/// with the line of a text, for a file that cannot be read or understood, and for more vertices than 2^31;
/// EmptySetError for one without vertices, NonFiniteError for a NaN or an infinity among them.
MeshFile read_mesh(const std::string& path);

/// The distinct vertices of a mesh as the columns of a 3 × N matrix, sorted: those that no face uses, too.
Eigen::MatrixXd distinct_vertices(const MeshFile& mesh);

}  // namespace raygauge::cli
