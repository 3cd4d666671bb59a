// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/thin.h"

#include <algorithm>
#include <cmath>

#include "generators/component.h"
#include "generators/hard/maps.h"
#include "generators/hard/polytopes.h"

namespace raygauge {
namespace {

bool is_power_of_two(double x) {
  int exponent = 0;
  return std::frexp(x, &exponent) == 0.5;
}

Instance generate_needle(const InstanceKey& key, const Parameters& parameters) {
  const double aspect = real_parameter(parameters, "aspect");
  const bool sheared = boolean_parameter(parameters, "sheared");
  const Eigen::Index last = key.n - 1;
  const Eigen::Index quarters = std::min<Eigen::Index>(2, last);
  PointClouds clouds{Eigen::MatrixXd::Zero(key.n, 1), vertices(Body::cross_polytope, key.n)};
  clouds.A.topRows(quarters).setConstant(0.25);
  clouds.A(last, 0) = 1 / aspect;
  clouds.Q.row(last) *= 1 / aspect;
  if (sheared && last > 0) {
    clouds.A.row(last) += clouds.A.row(0);
    clouds.Q.row(last) += clouds.Q.row(0);
  }
  std::optional<double> exact_distance;
  if (!sheared || last == 0 || is_power_of_two(aspect))
    exact_distance = 1 + 0.25 * static_cast<double>(quarters);
  return turned_instance(clouds, key, "hard_needle", exact_distance);
}

Instance generate_near_face(const InstanceKey& key, const Parameters& parameters) {
  const double delta = real_parameter(parameters, "delta");
  return turned_instance({facet_and_apex(key.n, delta, 1), vertices(body_of(parameters), key.n)}, key,
                         "hard_near_face", delta);
}

Instance generate_contact(const InstanceKey& key, const Parameters& parameters) {
  const double excess = static_cast<double>(integer_parameter(parameters, "ulps")) * 0x1p-52;
  const Body body = body_of(parameters);
  PointClouds clouds{facet_and_apex(key.n, 1 + excess, 2), vertices(body, key.n)};
  if (body == Body::cross_polytope) {
    clouds.A = Eigen::MatrixXd::Identity(key.n, key.n);
    clouds.A.row(0).array() += excess;
  }
  return turned_instance(clouds, key, "hard_contact", 1 + excess);
}

Instance generate_origin_near_facet(const InstanceKey& key, const Parameters& parameters) {
  const double delta = real_parameter(parameters, "delta");
  PointClouds clouds{-Eigen::MatrixXd::Identity(key.n, 1), facet_and_apex(key.n, -delta, 1)};
  return turned_instance(clouds, key, "hard_origin_near_facet", 1 / delta);
}

ParameterInfo delta_parameter() {
  return {"delta", 1e-9, 1e-300, 0.5, "the small distance", {}, "1", {"1/δ", reciprocal}};
}

}  // namespace

Component<Generator> hard_needle_generator() {
  return generator_component("hard_needle", "a flat cross-polytope, plain or sheared",
                             {{"aspect", 1e6, 1, 1e12, "length / thickness of Q", {}, "1", {"aspect"}},
                              {"sheared", false, {}, {}, "whether x_n += x_1 is applied", {}}},
                             generate_needle);
}

Component<Generator> hard_near_face_generator() {
  return generator_component("hard_near_face", "a facet of A very near the origin",
                             {body_parameter({"cross_polytope", "cube"}), delta_parameter()},
                             generate_near_face, 2);
}

Component<Generator> hard_contact_generator() {
  return generator_component("hard_contact", "contact, or a rounding error away from it",
                             {body_parameter({"cross_polytope", "cube"}),
                              {"ulps", std::int64_t{0}, -1024, 1024, "(d - 1) / 2^-52", {}}},
                             generate_contact, 2);
}

Component<Generator> hard_origin_near_facet_generator() {
  return generator_component("hard_origin_near_facet", "the origin very near a facet of Q",
                             {delta_parameter()}, generate_origin_near_facet, 2);
}

}  // namespace raygauge
