// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <random>

namespace raygauge::testing {

using Random = std::mt19937_64;

inline Eigen::Vector3d gaussian(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

inline Eigen::Quaterniond random_rotation(Random& random) {
  const Eigen::Vector3d v = gaussian(random);
  return Eigen::Quaterniond(gaussian(random).x(), v.x(), v.y(), v.z()).normalized();
}

}  // namespace raygauge::testing
