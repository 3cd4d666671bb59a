// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "raygauge/meshes/mesh.h"

namespace raygauge::bench {

struct TriangleSource {
  Eigen::Matrix3Xd vertices;
  std::vector<MeshTriangle> triangles;
};

/// Of radii 2 and 0.5, with about so many triangles.
TriangleSource torus(std::int64_t triangles);

}  // namespace raygauge::bench
