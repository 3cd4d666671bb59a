// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <random>

#include "raygauge/sets/pose.h"
#include "tests/engine/meshes/mesh_shapes.h"

/// Meshes in random poses, and the distance of two by a loop over all pairs of their triangles, none of which
/// is the engine's code.
namespace raygauge::testing {

inline Mesh mesh_of(const MeshShape& shape, MeshKind kind = MeshKind::surface) {
  return {shape.vertices, shape.triangles, kind};
}

inline Pose random_pose(std::mt19937_64& random, double far) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return {q.normalized(), far * Eigen::Vector3d(normal(random), normal(random), normal(random))};
}

/// So many turns by right angles, exactly, each about the axis that draw() names.
template <class Draw>
Eigen::Matrix3d right_turns(int turns, const Draw& draw) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (; turns > 0; --turns) {
    const int k = draw();
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();
    turn(k, k) = 1;
    turn((k + 1) % 3, (k + 2) % 3) = -1;
    turn((k + 2) % 3, (k + 1) % 3) = 1;
    R = turn * R;
  }
  return R;
}

/// The least distance of any two triangles of two surfaces, in quadruple precision.
struct BruteForce {
  double lower = std::numeric_limits<double>::infinity(), upper = lower;
  bool cross = false;  ///< an edge goes through the inside of a triangle
  bool meet = false;   ///< two triangles have a common point, to 1e-28 of the size
};

/// The surfaces of `one` and `two` in their poses, whose numbers are taken as they are. `upper` is the
/// distance of two points of them, to 1e-18 of their size; `lower` is less by 1e-16 of it, which two edges
/// that are parallel but for rounding may take away.
BruteForce brute_force(const MeshShape& one, const Pose& at_1, const MeshShape& two, const Pose& at_2);

/// The same in doubles, and faster: `upper` to 1e-14 of their size, `lower` less by 1e-7 of it.
BruteForce rough_force(const MeshShape& one, const Pose& at_1, const MeshShape& two, const Pose& at_2);

/// Whether the closed surface of `solid` winds about a point that is not on it, the sum of its triangles'
/// solid angles.
bool winds_about(const MeshShape& solid, const Pose& at, const Eigen::Vector3d& point);

}  // namespace raygauge::testing
