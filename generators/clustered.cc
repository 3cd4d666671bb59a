// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/clustered.h"

#include <cmath>

#include "generators/component.h"
#include "generators/separated_spheres.h"

namespace raygauge::clustered {
namespace {

constexpr const char* kName = "clustered";

Eigen::MatrixXd cluster_directions(RandomStream& stream, int n, int clusters) {
  Eigen::MatrixXd directions(n, clusters);
  for (int j = 0; j < clusters; ++j) {
    if (j % 2 == 0) {
      directions.col(j) = stream.unit_vector(n);
    } else {
      directions.col(j) = -directions.col(j - 1);
    }
  }
  return directions;
}

Vector near_direction(RandomStream& stream, const Vector& direction, double spread) {
  Vector x = direction;
  const double scale = spread / std::sqrt(static_cast<double>(x.size()));
  double norm2 = 0;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    x[k] += scale * stream.normal();
    norm2 += x[k] * x[k];
  }
  const double norm = std::sqrt(norm2);
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] /= norm;
  return x;
}

Eigen::MatrixXd clustered_points(const InstanceKey& key, RandomPurpose purpose,
                                 const Parameters& parameters) {
  RandomStream stream(key, kName, purpose);
  const int clusters = static_cast<int>(integer_parameter(parameters, "clusters"));
  const double spread = real_parameter(parameters, "spread");
  const Eigen::MatrixXd directions = cluster_directions(stream, key.n, clusters);
  Eigen::MatrixXd points(key.n, key.N);
  for (int i = 0; i < key.N; ++i)
    points.col(i) = near_direction(stream, directions.col(i % clusters), spread);
  return points;
}

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  PointClouds clouds{clustered_points(key, RandomPurpose::points_of_A, parameters),
                     clustered_points(key, RandomPurpose::points_of_Q, parameters)};
  move_apart(clouds, key, kName, real_parameter(parameters, "separation"));
  return to_instance(clouds);
}

}  // namespace
}  // namespace raygauge::clustered

namespace raygauge {

Component<Generator> clustered_generator() {
  return generator_component(
      clustered::kName, "as example2, the points of either sphere in clusters",
      {separation_parameter(),
       {"clusters", std::int64_t{16}, 2, 1e6, "clusters on either sphere, in antipodal pairs", {}},
       {"spread", 0.01, 1e-12, 0.5, "radius of a cluster", {}}},
      clustered::generate);
}

}  // namespace raygauge
