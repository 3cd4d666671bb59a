// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/random_segments.h"

#include <cmath>
#include <memory>
#include <string>

#include "generators/component.h"
#include "generators/separated_spheres.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"

namespace raygauge::random_segments {
namespace {

constexpr const char* kName = "random_segments";
constexpr const char* kBoth = "zonotope_zonotope";
constexpr const char* kObject = "zonotope_points";
constexpr const char* kGauge = "points_zonotope";
constexpr double kHalfPi = 1.57079632679489661923;

// Generators of a zonotope, or points of a cloud, one a column.
struct Shape {
  bool is_zonotope = false;
  Eigen::MatrixXd columns;
};

// E|u·g| of a uniform unit vector g is about sqrt(2 / (π n)).
Shape random_shape(const InstanceKey& key, RandomPurpose purpose, bool is_zonotope) {
  RandomStream stream(key, kName, purpose);
  Shape shape{is_zonotope, random_sphere_points(stream, key.n, key.N)};
  const double length = std::sqrt(kHalfPi * key.n) / key.N;
  for (Eigen::Index i = 0; is_zonotope && i < shape.columns.size(); ++i) shape.columns.data()[i] *= length;
  return shape;
}

// h(w), summed in a fixed order, whatever instructions the machine has; 1 for points of the unit sphere.
double extent(const Shape& shape, const Vector& w) {
  if (!shape.is_zonotope) return 1;
  double sum = 0;
  for (Eigen::Index i = 0; i < shape.columns.cols(); ++i) {
    double product = 0;
    for (Eigen::Index k = 0; k < shape.columns.rows(); ++k) product += shape.columns(k, i) * w[k];
    sum += std::fabs(product);
  }
  return sum;
}

std::shared_ptr<ConvexSet> placed(const Shape& shape, const Vector& center) {
  if (shape.is_zonotope) return std::make_shared<Zonotope>(center, shape.columns);
  Eigen::MatrixXd points = shape.columns;
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) += center;
  return std::make_shared<PointSet>(points);
}

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  if (key.N < key.n) {
    throw InvalidParameterError("generator 'random_segments': N must be at least n = " +
                                std::to_string(key.n) + ", got " + std::to_string(key.N));
  }
  const std::string& roles = string_parameter(parameters, "roles");
  const Shape A = random_shape(key, RandomPurpose::points_of_A, roles != kGauge);
  const Shape Q = random_shape(key, RandomPurpose::points_of_Q, roles != kObject);
  RandomStream placement(key, kName, RandomPurpose::placement);
  Vector center = placement.unit_vector(key.n);
  const double length = real_parameter(parameters, "separation") * (extent(A, center) + extent(Q, center));
  for (double& x : center) x *= length;
  return {placed(A, center), placed(Q, Vector::Zero(key.n)), {}};
}

}  // namespace
}  // namespace raygauge::random_segments

namespace raygauge {

Component<Generator> random_segments_generator() {
  using namespace random_segments;
  return generator_component(
      kName, "zonotopes of N random segments, nearly unit spheres where N is large",
      {{"separation", 1.5, 1.0, 1e15, "distance of the centres / sum of the extents along their line", {}},
       {"roles", std::string(kBoth), {}, {}, "which of A and Q is a zonotope", {kBoth, kObject, kGauge}}},
      generate);
}

}  // namespace raygauge
