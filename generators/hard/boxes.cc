// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/boxes.h"

#include <string>

#include "generators/component.h"
#include "generators/hard/maps.h"
#include "generators/hard/polytopes.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

// The point of Π_k [low_k, high_k] nearest to 0 in every coordinate: the minimiser of any absolute norm.
Vector nearest_to_origin(const Vector& low, const Vector& high) { return low.cwiseMax(0) + high.cwiseMin(0); }

Instance generate_point(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_point", RandomPurpose::points_of_A);
  Vector p(key.n);
  for (double& coordinate : p) coordinate = signed_integer(stream, 0, 1000);
  p[0] = signed_integer(stream, 1, 1000);
  const Body body = body_of(parameters);
  return to_instance({p, vertices(body, key.n)}, gauge(body, p));
}

Instance generate_box(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_box", RandomPurpose::points_of_A);
  Vector center(key.n), half_width(key.n);
  for (int k = 0; k < key.n; ++k) {
    center[k] = signed_integer(stream, k == 0 ? 6 : 0, 20);
    half_width[k] = random_integer(stream, 0, 5);
  }
  const Body body = body_of(parameters);
  return to_instance({box(center, half_width), vertices(body, key.n)},
                     gauge(body, nearest_to_origin(center - half_width, center + half_width)));
}

Eigen::Index lattice_size(Eigen::Index n, std::int64_t k) {
  constexpr Eigen::Index kMostPoints = 65536;
  Eigen::Index size = 1;
  for (Eigen::Index axis = 0; axis < n; ++axis) {
    size *= k + 1;
    if (size > kMostPoints) {
      throw InvalidParameterError("a lattice {0, …, k}^n is limited to " + std::to_string(kMostPoints) +
                                  " points: k = " + std::to_string(k) +
                                  " is too much for n = " + std::to_string(n));
    }
  }
  return size;
}

Eigen::MatrixXd lattice(const Vector& offset, std::int64_t k) {
  Eigen::MatrixXd points(offset.size(), lattice_size(offset.size(), k));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    Eigen::Index digits = i;
    for (Eigen::Index row = 0; row < points.rows(); ++row) {
      points(row, i) = offset[row] + static_cast<double>(digits % (k + 1));
      digits /= k + 1;
    }
  }
  return points;
}

Instance generate_lattice(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_lattice", RandomPurpose::points_of_A);
  const auto k = integer_parameter(parameters, "k");
  Vector offset(key.n);
  for (double& coordinate : offset) coordinate = signed_integer(stream, 0, 20);
  offset[0] = random_integer(stream, 1, 20);
  const Vector far_corner = offset.array() + static_cast<double>(k);
  const Body body = body_of(parameters);
  return to_instance({lattice(offset, k), vertices(body, key.n)},
                     gauge(body, nearest_to_origin(offset, far_corner)));
}

Instance generate_far(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_far", RandomPurpose::placement);
  const auto offset = integer_parameter(parameters, "offset");
  Vector center(key.n);
  for (double& coordinate : center) coordinate = signed_integer(stream, offset, offset + 1000);
  const Body body = body_of(parameters);
  const Eigen::MatrixXd Q = vertices(body, key.n);
  const Eigen::MatrixXd A = (-Q).colwise() + center;
  return to_instance({A, Q}, gauge(body, center) - 1);
}

}  // namespace

Component<Generator> hard_point_generator() {
  return generator_component("hard_point", "an integer point against a body with 2^n facets or vertices",
                             {body_parameter({"cross_polytope", "cube", "simplex"})}, generate_point);
}

Component<Generator> hard_box_generator() {
  return generator_component("hard_box", "an integer box against a cross-polytope or a cube",
                             {body_parameter({"cross_polytope", "cube"})}, generate_box);
}

Component<Generator> hard_lattice_generator() {
  return generator_component(
      "hard_lattice", "all points of an integer lattice box: collinear points, zero pivots",
      {body_parameter({"cross_polytope", "cube"}), {"k", std::int64_t{2}, 1, 255, "intervals an axis", {}}},
      generate_lattice);
}

Component<Generator> hard_far_generator() {
  return generator_component(
      "hard_far", "A = c - Q of unit size, far away",
      {body_parameter({"cross_polytope", "cube", "simplex"}),
       {"offset", std::int64_t{100000000}, 2, 0x1p40, "size of c's coordinates", {}, "1", {"offset"}}},
      generate_far);
}

}  // namespace raygauge
