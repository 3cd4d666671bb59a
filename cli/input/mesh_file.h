// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

namespace raygauge::cli {

/// Whether the name ends as a mesh's does: .obj, .off, .stl, .ply or .dae, in any case, also with .gz behind
/// it.
bool is_mesh_file(const std::string& path);

/// The vertices of a mesh file as the columns of a 3 × N matrix, each distinct one once: those that no face
/// uses too, with every digit, in the axes and the unit of the file (docs/meshes.md). Throws
/// InvalidParameterError, with the line of a text, for a file that cannot be read or understood,
/// EmptySetError for one without vertices, NonFiniteError for a NaN or an infinity among them.
Eigen::MatrixXd read_mesh_vertices(const std::string& path);

}  // namespace raygauge::cli
