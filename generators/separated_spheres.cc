// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/separated_spheres.h"

namespace raygauge {

ParameterInfo separation_parameter() {
  return {"separation", 1.5, 1.0, 1e15, "distance of the spheres' centres / sum of their radii", {}};
}

Eigen::MatrixXd random_sphere_points(RandomStream& stream, int n, int N) {
  Eigen::MatrixXd points(n, N);
  for (int i = 0; i < N; ++i) points.col(i) = stream.unit_vector(n);
  return points;
}

void move_apart(PointClouds& clouds, const InstanceKey& key, std::string_view generator, double separation) {
  RandomStream stream(key, generator, RandomPurpose::placement);
  Vector center = stream.unit_vector(key.n);
  for (Eigen::Index k = 0; k < center.size(); ++k) center[k] *= 2 * separation;
  for (Eigen::Index i = 0; i < clouds.A.cols(); ++i) clouds.A.col(i) += center;
}

}  // namespace raygauge
