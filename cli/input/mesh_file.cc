// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
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

/// A format, known by the ending of its files.
struct MeshFormat {
  std::string_view ending;
  MeshText (*read)(std::string_view bytes, const std::string& name);
};

constexpr std::array<MeshFormat, 8> kFormats = {{{"obj", obj_mesh},
                                                 {"off", off_mesh},
                                                 {"stl", stl_mesh},
                                                 {"ply", ply_mesh},
                                                 {"dae", collada_mesh},
                                                 {"glb", gltf_mesh},
                                                 {"gltf", gltf_mesh},
                                                 {"pcd", pcd_points}}};

const MeshFormat* format_of(const std::string& path) {
  const std::string ending = content_extension(path);
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const MeshFormat& format) { return format.ending == ending; });
  return found == kFormats.end() ? nullptr : &*found;
}

MeshText mesh_of(const std::string& bytes, const std::string& path) {
  if (const MeshFormat* format = format_of(path)) return format->read(bytes, path);
  std::string known;
  for (const MeshFormat& format : kFormats)
    known += (known.empty() ? "." : ", .") + std::string(format.ending);
  throw InvalidParameterError(path + ": not a mesh that is read, which are " + known);
}

}  // namespace

bool is_mesh_file(const std::string& path) { return format_of(path) != nullptr; }

MeshFile read_mesh(const std::string& path) {
  // Read here, so that a missing file, a directory, … are named as for every other kind of input.
  const std::string bytes = read_text_input(path);
  if (bytes.empty()) throw EmptySetError(path + ": the file is empty");
  const MeshText text = mesh_of(bytes, path);
  if (text.vertices.empty()) throw EmptySetError(path + ": no vertices");
  if (text.vertices.size() > std::numeric_limits<std::int32_t>::max())
    throw InvalidParameterError(path + ": more than 2^31 vertices");
  require_finite(text.vertices, path);
  MeshFile mesh;
  mesh.vertices = Eigen::Matrix3Xd::Map(text.vertices.front().data(), 3,
                                        static_cast<std::ptrdiff_t>(text.vertices.size()));
  const std::vector<std::uint32_t>& corners = text.faces.corners;
  std::size_t begin = 0, face = 0;
  const auto begin_runs = [&] {
    const std::size_t first = mesh.triangles.size();
    while (mesh.runs.size() < text.runs.size() && text.runs[mesh.runs.size()].first == face)
      mesh.runs.push_back({text.runs[mesh.runs.size()].name, first, first});
  };
  for (const std::size_t end : text.faces.ends) {
    begin_runs();
    cut_polygon(text.vertices, {corners.data() + begin, end - begin}, mesh.triangles);
    if (!mesh.runs.empty()) mesh.runs.back().end = mesh.triangles.size();
    begin = end;
    ++face;
  }
  begin_runs();
  return mesh;
}

Eigen::MatrixXd distinct_vertices(const MeshFile& mesh) {
  std::vector<Vertex> vertices(static_cast<std::size_t>(mesh.vertices.cols()));
  std::copy_n(mesh.vertices.data(), mesh.vertices.size(), vertices.front().data());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return Eigen::MatrixXd::Map(vertices.front().data(), 3, static_cast<std::ptrdiff_t>(vertices.size()));
}

}  // namespace raygauge::cli
