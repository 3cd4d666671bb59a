// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/needle.h"

#include "generators/component.h"
#include "generators/separated_spheres.h"

namespace raygauge::needle {
namespace {

constexpr const char* kName = "needle";

void stretch(Eigen::MatrixXd& points, const Vector& w, double aspect) {
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    double along = 0;
    for (Eigen::Index k = 0; k < points.rows(); ++k) along += w[k] * points(k, i);
    const double shift = (aspect - 1) * along;
    for (Eigen::Index k = 0; k < points.rows(); ++k) points(k, i) += shift * w[k];
  }
}

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream_of_A(key, kName, RandomPurpose::points_of_A);
  RandomStream stream_of_Q(key, kName, RandomPurpose::points_of_Q);
  PointClouds clouds{random_sphere_points(stream_of_A, key.n, key.N),
                     random_sphere_points(stream_of_Q, key.n, key.N)};
  move_apart(clouds, key, kName, real_parameter(parameters, "separation"));
  RandomStream shape(key, kName, RandomPurpose::shape);
  const Vector w = shape.unit_vector(key.n);
  const double aspect = real_parameter(parameters, "aspect");
  stretch(clouds.A, w, aspect);
  stretch(clouds.Q, w, aspect);
  return to_instance(clouds);
}

}  // namespace
}  // namespace raygauge::needle

namespace raygauge {

Component<Generator> needle_generator() {
  return generator_component(
      needle::kName, "as example2, both sets stretched along one random direction",
      {separation_parameter(), {"aspect", 1e4, 1.0, 1e12, "factor of the stretch", {}, "1", {"aspect"}}},
      needle::generate);
}

}  // namespace raygauge
