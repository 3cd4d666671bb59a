// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cli/input/input_file.h"
#include "cli/input/mesh_formats.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

/// Binary formats and maps of nodes give any double.
void require_finite(const std::vector<Vertex>& vertices, const std::string& path) {
  for (const Vertex& vertex : vertices) {
    for (const double value : vertex) {
      if (!std::isfinite(value)) {
        throw NonFiniteError(path + ": a vertex has the coordinate " +
                             (std::isnan(value) ? "NaN" : "infinity"));
      }
    }
  }
}

std::vector<Vertex> vertices_of(const std::string& bytes, const std::string& path) {
  const std::string format = content_extension(path);
  if (format == "obj") return obj_vertices(bytes, path);
  if (format == "off") return off_vertices(bytes, path);
  if (format == "ply") return ply_vertices(bytes, path);
  if (format == "stl") return stl_vertices(bytes, path);
  if (format == "dae") return collada_vertices(bytes, path);
  throw InvalidParameterError(path + ": not a mesh that is read: .obj, .off, .stl, .ply and .dae are");
}

}  // namespace

bool is_mesh_file(const std::string& path) {
  constexpr std::array<const char*, 5> kExtensions = {"obj", "off", "stl", "ply", "dae"};
  return std::find(kExtensions.begin(), kExtensions.end(), content_extension(path)) != kExtensions.end();
}

Eigen::MatrixXd read_mesh_vertices(const std::string& path) {
  // Read here, so that a missing file, a directory, … are named as for every other kind of input.
  const std::string bytes = read_text_input(path);
  if (bytes.empty()) throw EmptySetError(path + ": the file is empty");
  std::vector<Vertex> vertices = vertices_of(bytes, path);
  if (vertices.empty()) throw EmptySetError(path + ": no vertices");
  require_finite(vertices, path);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return Eigen::MatrixXd::Map(vertices.front().data(), 3, static_cast<std::ptrdiff_t>(vertices.size()));
}

}  // namespace raygauge::cli
