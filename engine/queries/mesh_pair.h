// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/meshes/box_tree.h"
#include "raygauge/queries/mesh_distance.h"
#include "raygauge/sets/half_space.h"

namespace raygauge {

/// A mesh, and the mesh, body or half-space that it is compared with, in the frame of the first mesh.
struct MeshPair {
  MeshPair() = default;
  MeshPair(const PosedMesh& A1, const PosedMesh& A2);
  MeshPair(const PosedMesh& A1, const Posed& A2);

  const BoxTree& tree_1() const noexcept { return first->tree(); }
  const BoxTree& tree_2() const noexcept { return mesh_2->tree(); }
  const BoxNode& node_2(std::int32_t i) const noexcept {
    return mesh_2 != nullptr ? tree_2().node(i) : box_2;
  }
  Vector3 to_first(const Vector3& x) const noexcept { return R * x + t; }

  /// Triangle `two` of the second mesh in the first frame.
  TriangleCorners turned(std::int32_t two) const noexcept;

  const Mesh* first = nullptr;
  const Mesh* mesh_2 = nullptr;       ///< or
  const ConvexSet* body_2 = nullptr;  ///< which may be
  const HalfSpace* half_space_2 = nullptr;
  BoxNode box_2{};  ///< of a body, in its own frame; a half-space has none
  const Pose* pose_1 = nullptr;
  const Pose* pose_2 = nullptr;
  Matrix3 W, R;  ///< first frame to world, second frame to first: x ↦ W x + w, R x + t
  Vector3 w, t;
  double radius_1 = 0, radii = 0;  ///< of the balls of a first cloud, of both objects together
  double margin = 0;               ///< what is computed of lengths is within this of the truth
  double single_slack = 0;         ///< what is computed of boxes in single precision is less this
  bool in_range = false, in_single_range = false;

 private:
  void place(const PosedMesh& A1, const Pose* second);
  void measure(double size_of_second);
  double set_box(const ConvexSet& body);
};

}  // namespace raygauge
