// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/meshes/surface.h"

namespace raygauge {

/// What it costs to take the convex hull of a mesh for the mesh.
struct HullCost {
  bool convex = false;
  bool closed = false;
  double volume = 0;       ///< that the mesh bounds; NaN unless it is closed
  double hull_volume = 0;  ///< of all vertices; NaN where the build or the hull has none
};

/// A mesh is convex if it bounds its hull, or is it in one plane, to kRoundedFile of its size. Proof: no
/// triangle is deeper in the hull than that, as the plane of each leaves every vertex on one side. So the
/// number of times that a closed surface winds about a point is the same for all points deeper inside; at the
/// centre it is 1.
HullCost hull_cost(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices,
                   std::span<const MeshTriangle> triangles);

/// What a file in single precision loses, and twice as much again by the programs before it.
inline constexpr double kRoundedFile = 1e-6;

/// How often a closed surface winds about p, from the solid angles of its triangles: a whole number, to
/// rounding, where p is not on it. (van Oosterom & Strackee, "The solid angle of a plane triangle", 1983.)
double winding_number(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices,
                      std::span<const MeshTriangle> triangles, const Vector3& p);

}  // namespace raygauge
