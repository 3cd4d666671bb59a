// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/tangent_facets.h"

#include <algorithm>
#include <memory>
#include <string>

#include "generators/component.h"
#include "generators/separated_spheres.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/polytopes.h"

namespace raygauge::tangent_facets {
namespace {

constexpr const char* kName = "tangent_facets";
constexpr const char* kBoth = "polytope_polytope";
constexpr const char* kObject = "polytope_points";
constexpr const char* kGauge = "points_polytope";

// The g_i, one a column.
Eigen::MatrixXd random_normals(RandomStream& stream, int n, int N) {
  Eigen::MatrixXd normals(n, N);
  for (int i = 0; i < N; ++i) {
    if (i % 2 == 0) {
      normals.col(i) = stream.unit_vector(n);
    } else {
      normals.col(i) = -normals.col(i - 1);
    }
  }
  return normals;
}

// g_i·x, summed in a fixed order, whatever instructions the machine has.
Vector products(const Eigen::MatrixXd& normals, const Vector& x) {
  Vector result(normals.cols());
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    double sum = 0;
    for (Eigen::Index k = 0; k < normals.rows(); ++k) sum += normals(k, i) * x[k];
    result[i] = sum;
  }
  return result;
}

// c - P: -g_i·x <= 1 - g_i·c.
std::shared_ptr<ConvexSet> reflected(const Eigen::MatrixXd& normals, const Vector& center) {
  Vector bounds = products(normals, center);
  for (double& bound : bounds) bound = 1 - bound;
  return std::make_shared<HPolytope>(-normals.transpose(), bounds);
}

std::shared_ptr<ConvexSet> sphere_points(const InstanceKey& key, RandomPurpose purpose,
                                         const Vector& center) {
  RandomStream stream(key, kName, purpose);
  Eigen::MatrixXd points = random_sphere_points(stream, key.n, key.N);
  for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) += center;
  return std::make_shared<PointSet>(points);
}

Instance generate(const InstanceKey& key, const Parameters& parameters) {
  if (key.N < 2 * key.n) {
    throw InvalidParameterError(
        "generator 'tangent_facets': N must be at least 2 n = " + std::to_string(2 * key.n) +
        " (facets in opposite pairs), got " + std::to_string(key.N));
  }
  RandomStream shape(key, kName, RandomPurpose::shape);
  RandomStream placement(key, kName, RandomPurpose::placement);
  const Eigen::MatrixXd normals = random_normals(shape, key.n, key.N);
  Vector center = placement.unit_vector(key.n);
  const double distance_of_center = 2 * real_parameter(parameters, "separation");
  const double gauge = products(normals, center).maxCoeff();
  for (double& x : center) x *= distance_of_center / gauge;

  const std::string& roles = string_parameter(parameters, "roles");
  if (roles == kGauge) {
    return {sphere_points(key, RandomPurpose::points_of_A, center),
            std::make_shared<HPolytope>(normals.transpose(), Vector::Ones(key.N)),
            {}};
  }
  if (roles == kObject) {
    return {
        reflected(normals, center), sphere_points(key, RandomPurpose::points_of_Q, Vector::Zero(key.n)), {}};
  }
  return {reflected(normals, center), std::make_shared<HPolytope>(normals.transpose(), Vector::Ones(key.N)),
          distance_of_center - 1};
}

}  // namespace
}  // namespace raygauge::tangent_facets

namespace raygauge {

Component<Generator> tangent_facets_generator() {
  using namespace tangent_facets;
  return generator_component(
      kName, "polytopes by N inequalities, tangent to the unit sphere at random points",
      {{"separation", 1.5, 1.0, 1e15, "half the gauge of A's centre", {}},
       {"roles", std::string(kBoth), {}, {}, "which of A and Q is a polytope", {kBoth, kObject, kGauge}}},
      generate, 2);
}

}  // namespace raygauge
