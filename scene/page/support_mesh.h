// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// Triangles, counterclockwise from outside.
struct SupportMesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;
};

/// The surface of a convex body of R^3, from its support points alone. The hull of the points found so far is
/// refined at the triangle t with the largest gap
///
///     h(n_t) - n_t·v,     n_t its unit normal, v a vertex of it,
///
/// until every gap is at most `tolerance` times the size of the body, or there are `most` vertices. A
/// polytope with at most `most` vertices comes out as it is. A flat body gets a thickness of the tolerance.
SupportMesh support_mesh(const ConvexSet& set, double tolerance, std::size_t most);

/// The same in the plane: the corners of a polygon, counterclockwise.
std::vector<Eigen::Vector2d> support_polygon(const ConvexSet& set, double tolerance, std::size_t most);

}  // namespace raygauge
