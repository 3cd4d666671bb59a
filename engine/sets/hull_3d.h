// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <utility>
#include <vector>

namespace raygauge {

/// The convex hull of points of R^3, as far as a PreparedSet needs it.
struct Hull3 {
  bool found = false;
  std::vector<std::ptrdiff_t>
      kept;  ///< the points that are not proven to be deep inside, vertices among them
  std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>>
      edges;                   ///< between vertices, each in both directions, sorted
  std::vector<int> triangles;  ///< of the surface, three indices each, counterclockwise from outside
  double inner_radius = 0;     ///< of a ball about `center` inside the hull
};

/// Whether the library is built with Qhull.
bool has_hull_3d() noexcept;

/// By Qhull; found = false without it, for flat sets and wherever Qhull gives up.
Hull3 hull_3d(const Eigen::MatrixXd& points, const Eigen::Vector3d& center);

}  // namespace raygauge
