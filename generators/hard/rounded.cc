// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/rounded.h"

#include <algorithm>
#include <cmath>

#include "generators/component.h"
#include "generators/hard/maps.h"
#include "generators/hard/polytopes.h"
#include "generators/portable_circle.h"
#include "generators/separated_spheres.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

Eigen::MatrixXd moment_curve_points(RandomStream& stream, int n, int N) {
  Eigen::MatrixXd points(n, N);
  for (int i = 0; i < N; ++i) {
    const double t = 2 * stream.uniform() - 1;
    double power = 1;
    for (int k = 0; k < n; ++k) points(k, i) = power *= t;
  }
  return points;
}

Vector mean_of(const Eigen::MatrixXd& points) {
  Vector sum = Vector::Zero(points.rows());
  for (Eigen::Index i = 0; i < points.cols(); ++i) sum += points.col(i);
  return sum / static_cast<double>(points.cols());
}

Instance generate_moment_curve(const InstanceKey& key, const Parameters&) {
  constexpr const char* kName = "hard_moment_curve";
  RandomStream stream_of_A(key, kName, RandomPurpose::points_of_A);
  RandomStream stream_of_Q(key, kName, RandomPurpose::points_of_Q);
  PointClouds clouds{moment_curve_points(stream_of_A, key.n, key.N),
                     moment_curve_points(stream_of_Q, key.n, key.N)};
  const Vector mean = mean_of(clouds.Q);
  clouds.Q.colwise() -= mean;
  move_apart(clouds, key, kName, 1);
  return to_instance(clouds);
}

// Every second vertex of the regular 2m-gon, beginning with vertex `first`, and apexes on the axes beyond
// two.
Eigen::MatrixXd bipyramid_over_polygon(int n, int m, int first) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(n, m + 2 * (n - 2));
  for (int j = 0; j < m; ++j) points.col(j).head(2) = circle_point(2 * j + first, 2 * std::int64_t{m});
  if (n > 2) points.bottomRightCorner(n - 2, 2 * (n - 2)) = vertices(Body::cross_polytope, n - 2);
  return points;
}

Instance generate_polygons(const InstanceKey& key, const Parameters& parameters) {
  if (key.N < 3) {
    throw InvalidParameterError("generator 'hard_polygons': N must be at least 3, got " +
                                std::to_string(key.N));
  }
  RandomStream stream(key, "hard_polygons", RandomPurpose::placement);
  PointClouds clouds{bipyramid_over_polygon(key.n, key.N, 1), bipyramid_over_polygon(key.n, key.N, 0)};
  const Eigen::Vector2d center = 2 * real_parameter(parameters, "separation") * stream.unit_vector(2);
  clouds.A.topRows(2).colwise() += center;
  return to_instance(clouds);
}

Eigen::MatrixXd minkowski_difference(const Eigen::MatrixXd& P1, const Eigen::MatrixXd& P2) {
  Eigen::MatrixXd points(P1.rows(), P1.cols() * P2.cols());
  for (Eigen::Index i = 0; i < P1.cols(); ++i) {
    for (Eigen::Index j = 0; j < P2.cols(); ++j) points.col(i * P2.cols() + j) = P1.col(i) - P2.col(j);
  }
  return points;
}

Instance generate_minkowski_difference(const InstanceKey& key, const Parameters& parameters) {
  constexpr const char* kName = "hard_minkowski_difference";
  const int count = static_cast<int>(std::sqrt(static_cast<double>(key.N)));
  RandomStream stream(key, kName, RandomPurpose::points_of_A);
  Eigen::MatrixXd P1 = random_sphere_points(stream, key.n, count);
  Eigen::MatrixXd P2 = random_sphere_points(stream, key.n, count);
  const Vector far = real_parameter(parameters, "offset") * stream.unit_vector(key.n);
  const Vector apart = 4 * stream.unit_vector(key.n);
  P1.colwise() += far + apart;
  P2.colwise() += far;
  return to_instance({minkowski_difference(P1, P2), vertices(Body::cross_polytope, key.n)});
}

Eigen::MatrixXd flat_points(RandomStream& stream, int n, int N, int rank) {
  Vector origin(n);
  for (double& coordinate : origin) coordinate = signed_integer(stream, 10, 20);
  Eigen::MatrixXd directions(n, rank);
  for (double& entry : directions.reshaped()) entry = random_integer(stream, -3, 3);
  Eigen::MatrixXd points(n, N);
  for (int i = 0; i < N; ++i) {
    points.col(i) = origin;
    for (int k = 0; k < rank; ++k) points.col(i) += random_integer(stream, -5, 5) * directions.col(k);
  }
  return points;
}

Instance generate_low_rank(const InstanceKey& key, const Parameters& parameters) {
  constexpr const char* kName = "hard_low_rank";
  const int rank = std::min(key.n, static_cast<int>(integer_parameter(parameters, "rank")));
  RandomStream stream_of_A(key, kName, RandomPurpose::points_of_A);
  RandomStream stream_of_Q(key, kName, RandomPurpose::points_of_Q);
  Eigen::MatrixXd Q(key.n, 2 * key.n + key.N);
  Q << vertices(Body::cross_polytope, key.n), random_sphere_points(stream_of_Q, key.n, key.N);
  return to_instance({flat_points(stream_of_A, key.n, key.N, rank), Q});
}

}  // namespace

Component<Generator> hard_moment_curve_generator() {
  return generator_component("hard_moment_curve", "points on the moment curve: ill-conditioned bases", {},
                             generate_moment_curve);
}

Component<Generator> hard_polygons_generator() {
  return generator_component("hard_polygons", "two N-gons with nearly parallel facets",
                             {separation_parameter()}, generate_polygons, 2);
}

Component<Generator> hard_minkowski_difference_generator() {
  return generator_component(
      "hard_minkowski_difference", "a Minkowski difference of point clouds far from the origin",
      {{"offset", 1e8, 0, 1e15, "distance of both clouds from the origin", {}, "1", {"offset"}}},
      generate_minkowski_difference);
}

Component<Generator> hard_low_rank_generator() {
  return generator_component("hard_low_rank", "A of low dimension",
                             {{"rank", std::int64_t{1}, 0, 1e3, "dimension of A, at most n", {}}},
                             generate_low_rank);
}

}  // namespace raygauge
