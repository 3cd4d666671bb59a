// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <random>

#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/point_set.h"
#include "tests/engine/meshes/mesh_shapes.h"

/// Meshes in random poses, and the distance of two by a loop over all pairs of their triangles.
namespace raygauge::testing {

inline Mesh mesh_of(const MeshShape& shape, MeshKind kind = MeshKind::surface) {
  return {shape.vertices, shape.triangles, kind};
}

inline Pose random_pose(std::mt19937_64& random, double far) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return {q.normalized(), far * Eigen::Vector3d(normal(random), normal(random), normal(random))};
}

/// The least distance of any two triangles, each solved as a pair of convex objects.
struct BruteForce {
  double lower = std::numeric_limits<double>::infinity(), upper = lower;
  bool meet = false;
};

inline BruteForce brute_force(const MeshShape& one, const Pose& at_1, const MeshShape& two,
                              const Pose& at_2) {
  BruteForce found;
  DistanceOptions options;
  options.tolerance = 1e-9;
  ObjectDistanceSolver solver(options);
  const Ball ball(Vector::Zero(3), 1);
  const auto corners = [](const MeshShape& mesh, const MeshTriangle& t) {
    Eigen::Matrix3d points;
    for (int k = 0; k < 3; ++k) points.col(k) = mesh.vertices.col(t[static_cast<std::size_t>(k)]);
    return points;
  };
  for (const MeshTriangle& s : one.triangles) {
    const PointSet first(corners(one, s));
    for (const MeshTriangle& t : two.triangles) {
      const PointSet second(corners(two, t));
      const DistanceResult& r = solver.solve({first, at_1}, {second, at_2}, ball).distance;
      found.meet |= r.status == DistanceStatus::contains_origin;
      found.lower = std::min(found.lower, r.lower);
      found.upper = std::min(found.upper, r.upper);
    }
  }
  return found;
}

}  // namespace raygauge::testing
