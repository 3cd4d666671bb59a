// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/maps.h"

#include <cmath>

namespace raygauge {
namespace {

// Random elementary operations row_i ± row_j, until one would lead beyond largest_entry.
Eigen::MatrixXd unimodular_matrix(RandomStream& stream, int n, double largest_entry) {
  Eigen::MatrixXd U = Eigen::MatrixXd::Identity(n, n);
  if (n == 1) return U;
  const int most_operations = 1000 * n;
  for (int operation = 0; operation < most_operations; ++operation) {
    const auto i = stream.integer(0, n - 1);
    const auto j = (i + stream.integer(1, n - 1)) % n;
    const double sign = signed_integer(stream, 1, 1);
    const Eigen::RowVectorXd row = U.row(i) + sign * U.row(j);
    if (row.cwiseAbs().maxCoeff() > largest_entry) break;
    U.row(i) = row;
  }
  return U;
}

Eigen::MatrixXd product(const Eigen::MatrixXd& U, const Eigen::MatrixXd& points) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(U.rows(), points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index k = 0; k < U.cols(); ++k) result.col(i) += U.col(k) * points(k, i);
  }
  return result;
}

Eigen::MatrixXd with_axes_turned(const Eigen::MatrixXd& points, const std::vector<std::ptrdiff_t>& order,
                                 const Vector& signs) {
  Eigen::MatrixXd result(points.rows(), points.cols());
  for (Eigen::Index k = 0; k < points.rows(); ++k) {
    result.row(k) = signs[k] * points.row(order[static_cast<std::size_t>(k)]);
  }
  return result;
}

}  // namespace

void turn_axes(PointClouds& clouds, RandomStream& stream) {
  const auto order = stream.permutation(clouds.A.rows());
  Vector signs(clouds.A.rows());
  for (double& sign : signs) sign = signed_integer(stream, 1, 1);
  clouds.A = with_axes_turned(clouds.A, order, signs);
  clouds.Q = with_axes_turned(clouds.Q, order, signs);
}

Instance turned_instance(PointClouds clouds, const InstanceKey& key, std::string_view generator,
                         std::optional<double> exact_distance) {
  RandomStream stream(key, generator, RandomPurpose::shape);
  turn_axes(clouds, stream);
  return to_instance(clouds, exact_distance);
}

void apply_unimodular(PointClouds& clouds, RandomStream& stream, double largest_entry) {
  const Eigen::MatrixXd U = unimodular_matrix(stream, static_cast<int>(clouds.A.rows()), largest_entry);
  clouds.A = product(U, clouds.A);
  clouds.Q = product(U, clouds.Q);
}

Eigen::MatrixXd repeated_and_shuffled(const Eigen::MatrixXd& points, int copies, RandomStream& stream) {
  Eigen::MatrixXd result(points.rows(), points.cols() * copies);
  const auto order = stream.permutation(result.cols());
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    result.col(i) = points.col(order[static_cast<std::size_t>(i)] % points.cols());
  }
  return result;
}

Eigen::MatrixXd scaled_by_power_of_two(const Eigen::MatrixXd& points, int exponent) {
  return points * std::ldexp(1.0, exponent);
}

double random_integer(RandomStream& stream, std::int64_t first, std::int64_t last) {
  return static_cast<double>(stream.integer(first, last));
}

double signed_integer(RandomStream& stream, std::int64_t first, std::int64_t last) {
  const double value = random_integer(stream, first, last);
  return stream.uniform() < 0.5 ? -value : value;
}

}  // namespace raygauge
