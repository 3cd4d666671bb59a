// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/ties.h"

#include <algorithm>
#include <cmath>

#include "generators/component.h"
#include "generators/hard/maps.h"
#include "generators/hard/polytopes.h"

namespace raygauge {
namespace {

Instance generate_cross_polytope(const InstanceKey& key, const Parameters&) {
  RandomStream stream(key, "hard_cross_polytope", RandomPurpose::points_of_A);
  const double t = random_integer(stream, 1, 50);
  Vector center(key.n);
  for (double& coordinate : center) coordinate = signed_integer(stream, 0, 100);
  center[0] = signed_integer(stream, 51, 100);
  double r = 0;
  for (const double coordinate : center) r += std::max(0.0, std::abs(coordinate) - t);
  const Eigen::MatrixXd A = (r * vertices(Body::cross_polytope, key.n)).colwise() + center;
  return to_instance({A, vertices(Body::cube, key.n)}, t);
}

Instance generate_scaled_simplex(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_scaled_simplex", RandomPurpose::shape);
  const double level = random_integer(stream, 1, 1000);
  const Body body = body_of(parameters);
  const double s = level * key.n;
  PointClouds clouds{s * Eigen::MatrixXd::Identity(key.n, key.n), vertices(body, key.n)};
  turn_axes(clouds, stream);
  return to_instance(clouds, body == Body::cube ? level : s);
}

// A vertex of Q or the midpoint of an edge, exact as all coordinates are 0 or ±1. Vertices 0 and 1 share an
// edge in every body, for n >= 2.
Vector feature_point(const std::string& feature, const Eigen::MatrixXd& Q) {
  if (feature == "vertex") return Q.col(0);
  return (Q.col(0) + Q.col(1)) / 2;
}

Instance generate_vertex(const InstanceKey& key, const Parameters& parameters) {
  RandomStream stream(key, "hard_vertex", RandomPurpose::shape);
  const double lambda = real_parameter(parameters, "lambda");
  const Body body = body_of(parameters);
  const Eigen::MatrixXd Q = vertices(body, key.n);
  PointClouds clouds{lambda * feature_point(string_parameter(parameters, "feature"), Q), Q};
  turn_axes(clouds, stream);
  return to_instance(clouds, lambda);
}

}  // namespace

Component<Generator> hard_cross_polytope_generator() {
  return generator_component("hard_cross_polytope", "an integer cross-polytope against the cube", {},
                             generate_cross_polytope);
}

Component<Generator> hard_scaled_simplex_generator() {
  return generator_component("hard_scaled_simplex", "a facet parallel to one of Q's: all of A is optimal",
                             {body_parameter({"cross_polytope", "cube"})}, generate_scaled_simplex);
}

Component<Generator> hard_vertex_generator() {
  constexpr int kMinimumDimension = 2;
  return generator_component(
      "hard_vertex", "a multiple of a vertex or an edge midpoint of Q: the normal is not unique",
      {body_parameter({"cross_polytope", "cube", "simplex"}),
       {"feature", std::string("vertex"), {}, {}, "where A touches", {"vertex", "edge_midpoint"}},
       {"lambda", 3.0, 1e-150, 1e150, "the exact distance", {}}},
      generate_vertex, kMinimumDimension);
}

}  // namespace raygauge
