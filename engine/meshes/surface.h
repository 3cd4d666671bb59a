// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "raygauge/meshes/mesh.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// What the edges of triangles say. Vertices at the same place count as one.
struct SurfaceFacts {
  /// Edges with more triangles on one side than on the other: holes, or triangles turned about. A surface
  /// without such edges winds about every point off it a whole number of times.
  std::ptrdiff_t open_edges = 0;
  std::int32_t open_triangle = -1;  ///< one with such an edge
  /// A vertex of each connected part of the surface.
  std::vector<std::int32_t> parts;

  bool closed() const noexcept { return open_edges == 0; }
};

/// Of triangles whose indices name columns of `vertices`, 3 × N.
SurfaceFacts surface_facts(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices,
                           std::span<const MeshTriangle> triangles);

/// For each vertex the first one at the same place.
std::vector<std::int32_t> first_at_place(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices);

/// The volume that a closed surface bounds, parts about which it winds twice counted twice. To rounding.
double enclosed_volume(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices,
                       std::span<const MeshTriangle> triangles);

inline Vector3 column(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices, std::int32_t i) {
  const double* p = vertices.data() + std::ptrdiff_t{i} * vertices.outerStride();
  return {p[0], p[1], p[2]};
}

}  // namespace raygauge
