// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/smooth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generators/component.h"
#include "generators/hard/homothets.h"
#include "generators/hard/maps.h"
#include "generators/hard/similarities.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/p_norm_ball.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {
namespace {

Instance generate_tangent_disc(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_tangent_disc", RandomPurpose::shape);
  const HalfPlane plane = random_half_plane(stream, key.n, 2, 1);
  const double epsilon = on_grid(real_parameter(parameters, "epsilon"));
  const long double exact = epsilon;
  const auto Q = std::make_shared<Ball>(plane.along, plane.unit);
  return {std::make_shared<PointSet>(plane.point(epsilon, 1)), Q,
          static_cast<double>((1 + exact * exact) / (2 * exact))};
}

long double p_norm(const Vector& z, double p) {
  const long double largest = z.cwiseAbs().maxCoeff();
  long double sum = 0;
  for (const double coordinate : z) {
    sum += std::pow(std::fabs(static_cast<long double>(coordinate)) / largest, static_cast<long double>(p));
  }
  return largest * std::pow(sum, 1 / static_cast<long double>(p));
}

Instance generate_p_norm_ball(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_p_norm_ball", RandomPurpose::shape);
  const double p = real_parameter(parameters, "p");
  Vector semi_axes(key.n), z(key.n);
  for (double& semi_axis : semi_axes) semi_axis = std::ldexp(1.0, static_cast<int>(stream.integer(-2, 2)));
  for (double& coordinate : z) coordinate = signed_integer(stream, 1, 9);
  const Homothet ball = [&](const Vector& center, double factor) {
    return std::make_shared<PNormBall>(center, std::fabs(factor) * semi_axes, p);
  };
  return homothets(stream, parameters, ball, semi_axes.cwiseProduct(z), p_norm(z, p));
}

// Semi-axes from 1 to `largest`, both of them met.
Vector random_semi_axes(RandomStream& stream, int n, double largest) {
  const int exponent = std::ilogb(largest);
  Vector semi_axes(n);
  for (double& semi_axis : semi_axes)
    semi_axis = std::ldexp(1.0, static_cast<int>(stream.integer(0, exponent)));
  semi_axes[0] = largest;
  semi_axes[1] = 1;
  return semi_axes;
}

Instance generate_ellipsoid(const InstanceKey& key, const Parameters& parameters) {
  constexpr int kLayers = 3;
  RandomStream stream(key, "hard_ellipsoid", RandomPurpose::shape);
  Eigen::MatrixXd factor = integer_similarity(stream, key.n, kLayers);
  const Vector semi_axes = random_semi_axes(stream, key.n, std::round(real_parameter(parameters, "aspect")));
  for (Eigen::Index k = 0; k < key.n; ++k) factor.col(k) *= semi_axes[k];
  const Vector z = integer_similarity(stream, key.n, kLayers).col(0);
  const double length = std::pow(5.0, kLayers);
  Vector p = Vector::Zero(key.n);
  for (Eigen::Index k = 0; k < key.n; ++k) p += z[k] * factor.col(k);
  const Homothet ellipsoid = [&](const Vector& center, double scale) {
    return std::make_shared<Ellipsoid>(center, std::fabs(scale) * length * factor);
  };
  return homothets(stream, parameters, ellipsoid, p);
}

}  // namespace

Component<Generator> hard_tangent_disc_generator() {
  return generator_component("hard_tangent_disc", "a point near the tangent at 0 of a ball that touches 0",
                             {{"epsilon", 1e-3, 0, 1, "height of A above the tangent; 0: out of reach", {}}},
                             generate_tangent_disc, 2);
}

Component<Generator> hard_p_norm_ball_generator() {
  return generator_component("hard_p_norm_ball", "homothetic balls of a weighted p-norm",
                             {{"p", 3.0, 1, 1e6, "exponent of the norm", {}}, object_parameter()},
                             generate_p_norm_ball, 2);
}

Component<Generator> hard_ellipsoid_generator() {
  return generator_component(
      "hard_ellipsoid", "homothetic ellipsoids, flat and turned",
      {{"aspect", 1e4, 1, 1e10, "longest semi-axis / shortest", {}, "1", {"aspect"}}, object_parameter()},
      generate_ellipsoid, 2);
}

}  // namespace raygauge
