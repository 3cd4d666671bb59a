// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/fcl_geometry.h"

#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/capsule.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge::bench {

Eigen::Vector3d uniform_vector(Random& random, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  return {uniform(random), uniform(random), uniform(random)};
}

Eigen::Vector3d uniform_vector(Random& random, double size) { return uniform_vector(random, -size, size); }

Geometry make_geometry(GeometryKind kind, double low, double high, Random& random) {
  const Eigen::Vector3d half = uniform_vector(random, low, high), zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d up(0, 0, half[2]);
  switch (kind) {
    case GeometryKind::box:
      return {std::make_shared<Box>(-half, half), std::make_shared<fcl::Boxd>(Eigen::Vector3d(2 * half))};
    case GeometryKind::capsule:
      return {std::make_shared<Capsule>(-up, up, half[0]),
              std::make_shared<fcl::Capsuled>(half[0], 2 * half[2])};
    case GeometryKind::cylinder:
      return {std::make_shared<Cylinder>(-up, up, half[0]),
              std::make_shared<fcl::Cylinderd>(half[0], 2 * half[2])};
    case GeometryKind::ball:
      return {std::make_shared<Ball>(zero, half[0]), std::make_shared<fcl::Sphered>(half[0])};
    case GeometryKind::ellipsoid:
      return {std::make_shared<Ellipsoid>(zero, Eigen::MatrixXd(half.asDiagonal())),
              std::make_shared<fcl::Ellipsoidd>(half)};
  }
  return {};
}

}  // namespace raygauge::bench
