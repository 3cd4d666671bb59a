// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/mesh_object_file.h"

#include "cli/input/mesh_file.h"
#include "cli/input/toml_refusal.h"
#include "raygauge/exceptions.h"
#include "raygauge/meshes/mesh_object.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::cli {

std::shared_ptr<const ConvexSet> read_mesh_as(const std::string& path, const std::string& as) {
  if (as != "hull" && as != "surface" && as != "solid")
    throw UnknownNameError("way to take a mesh", as, {"hull", "surface", "solid"});
  const MeshFile file = read_mesh(path);
  if (as == "hull") return std::make_shared<PointSet>(distinct_vertices(file));
  const MeshKind kind = as == "solid" ? MeshKind::solid : MeshKind::surface;
  return placed(path,
                [&] { return std::make_shared<MeshObject>(Mesh(file.vertices, file.triangles, kind)); });
}

}  // namespace raygauge::cli
