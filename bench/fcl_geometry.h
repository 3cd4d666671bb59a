// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fcl/fcl.h>

#include <Eigen/Core>
#include <memory>
#include <random>

#include "raygauge/sets/convex_set.h"

namespace raygauge::bench {

using Random = std::mt19937_64;

/// A vector of R^3 of numbers of [low, high), or of [-size, size).
Eigen::Vector3d uniform_vector(Random& random, double low, double high);
Eigen::Vector3d uniform_vector(Random& random, double size);

/// A body of ours, and the same body as FCL has it.
struct Geometry {
  std::shared_ptr<const ConvexSet> set;
  std::shared_ptr<fcl::CollisionGeometryd> fcl;
};

enum class GeometryKind : unsigned char { box, capsule, cylinder, ball, ellipsoid };

/// About the origin, of random half edges in [low, high) (radius, half length, half axes).
Geometry make_geometry(GeometryKind kind, double low, double high, Random& random);

}  // namespace raygauge::bench
