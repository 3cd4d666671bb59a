// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/origin.h"

#include "engine/numerics/floating_point.h"
#include "generators/component.h"
#include "generators/hard/maps.h"
#include "generators/hard/polytopes.h"

namespace raygauge {
namespace {

Eigen::MatrixXd axis_point(int n, double x_1, double x_2) {
  Eigen::MatrixXd point = Eigen::MatrixXd::Zero(n, 1);
  point(0, 0) = x_1;
  point(1, 0) = x_2;
  return point;
}

Instance generate_origin_in_object(const InstanceKey& key, const Parameters& parameters) {
  const std::string place = string_parameter(parameters, "place");
  RandomStream stream(key, "hard_origin_in_object", RandomPurpose::points_of_A);
  Vector center(key.n);
  for (double& coordinate : center) coordinate = signed_integer(stream, 1, 10);
  double r = gauge(Body::cross_polytope, center);
  if (place == "interior") r += random_integer(stream, 1, 10);
  if (place == "vertex") center = -r * Vector::Unit(key.n, 0);
  const Body body = body_of(parameters);
  const Eigen::MatrixXd A = (r * vertices(Body::cross_polytope, key.n)).colwise() + center;
  return turned_instance({A, vertices(body, key.n)}, key, "hard_origin_in_object", 0);
}

Instance generate_origin_on_boundary(const InstanceKey& key, const Parameters& parameters) {
  const bool reachable = boolean_parameter(parameters, "reachable");
  const Eigen::MatrixXd A = reachable ? axis_point(key.n, 3, 1) : axis_point(key.n, -1e-9, 0.5);
  return turned_instance({A, facet_and_apex(key.n, 0, 2)}, key, "hard_origin_on_boundary",
                         reachable ? 2.5 : kInfinity);
}

Instance generate_origin_outside(const InstanceKey& key, const Parameters& parameters) {
  const bool reachable = boolean_parameter(parameters, "reachable");
  const Eigen::MatrixXd A = reachable ? axis_point(key.n, 3, 1) : axis_point(key.n, 1, 3);
  return turned_instance({A, facet_and_apex(key.n, 1, 2)}, key, "hard_origin_outside",
                         reachable ? 2 : kInfinity);
}

Instance generate_flat(const InstanceKey& key, const Parameters& parameters) {
  const bool crossing = boolean_parameter(parameters, "crossing");
  const double delta = real_parameter(parameters, "delta");
  const int n = key.n;
  PointClouds clouds{Eigen::MatrixXd::Zero(n, 2), Eigen::MatrixXd::Zero(n, 2 * n - 2)};
  clouds.Q.topRows(n - 1) = vertices(Body::cross_polytope, n - 1);
  clouds.A.row(0) << 3, 5;
  clouds.A.row(n - 1) << (crossing ? -delta : delta), delta;
  return turned_instance(clouds, key, "hard_flat", crossing ? 4 : kInfinity);
}

ParameterInfo reachable_parameter() {
  return {"reachable", true, {}, {}, "whether some multiple of Q meets A", {}};
}

}  // namespace

Component<Generator> hard_origin_in_object_generator() {
  return generator_component("hard_origin_in_object", "A contains the origin",
                             {body_parameter({"cross_polytope", "cube", "simplex"}),
                              {"place",
                               std::string("interior"),
                               {},
                               {},
                               "where in A the origin is",
                               {"interior", "face", "vertex"}}},
                             generate_origin_in_object);
}

Component<Generator> hard_origin_on_boundary_generator() {
  return generator_component("hard_origin_on_boundary", "the origin on the boundary of Q",
                             {reachable_parameter()}, generate_origin_on_boundary, 2);
}

Component<Generator> hard_origin_outside_generator() {
  return generator_component("hard_origin_outside", "the origin outside Q", {reachable_parameter()},
                             generate_origin_outside, 2);
}

Component<Generator> hard_flat_generator() {
  return generator_component(
      "hard_flat", "a flat Q, with A through its plane or next to it",
      {{"crossing", true, {}, {}, "whether A crosses the plane of Q", {}},
       {"delta", 1e-9, 1e-300, 1, "distance of A's points from the plane", {}, "1", {"1/δ", reciprocal}}},
      generate_flat, 2);
}

}  // namespace raygauge
