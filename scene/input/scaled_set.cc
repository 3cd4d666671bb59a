// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/scaled_set.h"

#include <cmath>
#include <memory>
#include <vector>

#include "engine/meshes/box_tree.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/half_space.h"
#include "raygauge/sets/operations.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::cli {
namespace {

// A negative scale turns the surface inside out, and its triangles about.
SetPointer scaled_mesh(const Mesh& mesh, double scale) {
  if (mesh.kind() == MeshKind::cloud) {
    Eigen::Matrix3Xd points(3, mesh.size());
    for (std::int32_t i = 0; i < mesh.size(); ++i) {
      const Vector3& p = mesh.tree().triangle(i).corner[0];
      points.col(i) = scale * Eigen::Vector3d(p.x, p.y, p.z);
    }
    return std::make_shared<MeshObject>(Mesh::cloud(points, std::fabs(scale) * mesh.radius()));
  }
  Eigen::Matrix3Xd corners(3, 3 * mesh.size());
  std::vector<MeshTriangle> triangles(static_cast<std::size_t>(mesh.size()));
  for (std::int32_t i = 0; i < mesh.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const Vector3& p = mesh.tree().triangle(i).corner[c];
      corners.col(3 * Eigen::Index{i} + c) = scale * Eigen::Vector3d(p.x, p.y, p.z);
    }
    const std::int32_t first = 3 * i, one = scale > 0 ? 1 : 2;
    triangles[static_cast<std::size_t>(i)] = {first, first + one, first + 3 - one};
  }
  return std::make_shared<MeshObject>(Mesh(corners, triangles, mesh.kind()));
}

}  // namespace

SetPointer scaled(const SetPointer& set, double scale) {
  if (const Mesh* mesh = as_mesh(*set)) return scaled_mesh(*mesh, scale);
  if (const PointSet* points = as_point_set(*set))
    return std::make_shared<PointSet>(scale * points->points());
  if (const HalfSpace* half_space = as_half_space(*set)) {
    const double sign = scale > 0 ? 1 : -1;
    return std::make_shared<HalfSpace>(sign * half_space->normal(), std::fabs(scale) * half_space->offset());
  }
  const int n = set->dimension();
  return std::make_shared<AffineImage>(set, scale * Eigen::MatrixXd::Identity(n, n),
                                       Eigen::VectorXd::Zero(n));
}

}  // namespace raygauge::cli
