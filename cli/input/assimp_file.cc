// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <assimp/config.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "cli/input/mesh_formats.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

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

}  // namespace

std::vector<Vertex> assimp_vertices(std::string_view bytes, const std::string& name,
                                    const std::string& extension) {
  Assimp::Importer importer;
  // Else a file of another up axis than y would be turned: a mesh is placed by its own axes, whichever is up.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extension.c_str());
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw InvalidParameterError(name + ": not a mesh that can be read: " + importer.GetErrorString());
  }
  std::vector<Vertex> vertices;
  append_vertices(*scene, *scene->mRootNode, aiMatrix4x4(), vertices);
  return vertices;
}

}  // namespace raygauge::cli
