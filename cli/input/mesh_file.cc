// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <vector>

#include "cli/input/input_file.h"
#include "cli/input/vertex_reader.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void append_vertices(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
                     std::vector<Vertex>& out) {
  const aiMatrix4x4 transformation = parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    for (unsigned k = 0; k < mesh.mNumVertices; ++k) {
      const aiVector3D v = transformation * mesh.mVertices[k];
      out.push_back({v.x, v.y, v.z});
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    append_vertices(scene, *node.mChildren[i], transformation, out);
}

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

std::vector<Vertex> assimp_vertices(const std::string& bytes, const std::string& path) {
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, content_extension(path).c_str());
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InvalidParameterError(path +
                                ": not a mesh that can be read: " + one_line(importer.GetErrorString()));
  }
  std::vector<Vertex> vertices;
  append_vertices(*scene, *scene->mRootNode, aiMatrix4x4(), vertices);
  return vertices;
}

/// Formats whose header could promise too much are read here.
std::vector<Vertex> vertices_of(const std::string& bytes, const std::string& path) {
  const std::string format = content_extension(path);
  if (format == "off") return off_vertices(bytes, path);
  if (format == "ply") return ply_vertices(bytes, path);
  if (format == "stl" && is_binary_stl(bytes)) return binary_stl_vertices(bytes);
  if (format == "stl" && !bytes.starts_with("solid"))
    throw InvalidParameterError(path + ": neither a text STL file nor a whole binary one");
  return assimp_vertices(bytes, path);
}

}  // namespace

bool is_mesh_file(const std::string& path) {
  constexpr std::array<const char*, 4> kExtensions = {"obj", "off", "stl", "ply"};
  return std::find(kExtensions.begin(), kExtensions.end(), content_extension(path)) != kExtensions.end();
}

Eigen::MatrixXd read_mesh_vertices(const std::string& path) {
  // Read here, so that a missing file, a directory, … are named as for every other kind of input.
  const std::string bytes = read_input(path);
  if (bytes.empty()) throw EmptySetError(path + ": the file is empty");
  std::vector<Vertex> vertices = vertices_of(bytes, path);
  if (vertices.empty()) throw EmptySetError(path + ": no vertices");
  require_finite(vertices, path);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return Eigen::MatrixXd::Map(vertices.front().data(), 3, static_cast<std::ptrdiff_t>(vertices.size()));
}

}  // namespace raygauge::cli
