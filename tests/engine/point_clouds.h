// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <random>

namespace raygauge {

/// Point clouds for the engine's own tests: n × N, one point a column.
using Random = std::mt19937_64;

inline Eigen::MatrixXd gaussian_points(int n, int N, Random& random) {
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(n, N, [&] { return normal(random); });
}

inline Eigen::MatrixXd sphere_points(int n, int N, Random& random) {
  Eigen::MatrixXd points = gaussian_points(n, N, random);
  points.colwise().normalize();
  return points;
}

/// Integer coordinates in [-bound, bound]: sums of their products are exact, and ties are plenty.
inline Eigen::MatrixXd integer_points(int n, int N, int bound, Random& random) {
  std::uniform_int_distribution<int> integer(-bound, bound);
  return Eigen::MatrixXd::NullaryExpr(n, N, [&] { return static_cast<double>(integer(random)); });
}

/// A few tight clusters on the unit sphere.
inline Eigen::MatrixXd clustered_points(int n, int N, Random& random) {
  const int clusters = 2 * n;
  Eigen::MatrixXd points(n, N);
  Eigen::MatrixXd centers(n, clusters);
  centers.leftCols(n) = sphere_points(n, n, random);
  centers.rightCols(n) = -centers.leftCols(n);
  for (int i = 0; i < N; ++i) {
    points.col(i) = centers.col(i % clusters) + 1e-3 * gaussian_points(n, 1, random);
  }
  return points;
}

/// [-1, 1]^n.
inline Eigen::MatrixXd cube_vertices(int n) {
  return Eigen::MatrixXd::NullaryExpr(
      n, 1 << n, [](Eigen::Index k, Eigen::Index i) { return (i >> k) % 2 == 0 ? -1.0 : 1.0; });
}

/// {±e_i}.
inline Eigen::MatrixXd cross_polytope_vertices(int n) {
  Eigen::MatrixXd vertices(n, 2 * n);
  vertices << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
  return vertices;
}

/// {e_1, …, e_n, -(1, …, 1)}.
inline Eigen::MatrixXd simplex_vertices(int n) {
  Eigen::MatrixXd vertices(n, n + 1);
  vertices << Eigen::MatrixXd::Identity(n, n), -Eigen::VectorXd::Ones(n);
  return vertices;
}

/// {0, …, k}^n.
inline Eigen::MatrixXd lattice_points(int n, int k) {
  int N = 1;
  for (int i = 0; i < n; ++i) N *= k + 1;
  Eigen::MatrixXd points(n, N);
  for (int i = 0; i < N; ++i) {
    for (int row = 0, rest = i; row < n; ++row, rest /= k + 1) points(row, i) = rest % (k + 1);
  }
  return points;
}

}  // namespace raygauge
