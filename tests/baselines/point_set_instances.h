// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <random>

#include "raygauge/sets/point_set.h"
#include "raygauge/sweep/instance.h"

namespace raygauge::testing {

using Matrix = Eigen::MatrixXd;

inline Instance instance(const Matrix& A, const Matrix& Q) {
  return {std::make_shared<PointSet>(A), std::make_shared<PointSet>(Q), {}};
}

/// Points given one by one: points({{1, 2}, {3, 4}}) is two points of the plane.
inline Matrix points(std::initializer_list<std::initializer_list<double>> list) {
  Matrix result(static_cast<Eigen::Index>(list.begin()->size()), static_cast<Eigen::Index>(list.size()));
  Eigen::Index column = 0;
  for (const auto& point : list) {
    Eigen::Index row = 0;
    for (const double coordinate : point) result(row++, column) = coordinate;
    ++column;
  }
  return result;
}

/// The 2^n vertices of c + [-h, h]^n.
inline Matrix cube(const Vector& c, double h = 1) {
  const Eigen::Index n = c.size();
  Matrix result(n, Eigen::Index{1} << n);
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    for (Eigen::Index k = 0; k < n; ++k) result(k, i) = c[k] + (((i >> k) & 1) != 0 ? h : -h);
  }
  return result;
}

/// The 2n points c ± r e_k.
inline Matrix cross_polytope(const Vector& c, double r = 1) {
  const Eigen::Index n = c.size();
  Matrix result = c.replicate(1, 2 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    result(k, 2 * k) += r;
    result(k, 2 * k + 1) -= r;
  }
  return result;
}

/// The simplex {e_1, …, e_n, (-1, …, -1)}.
inline Matrix corner_simplex(Eigen::Index n) {
  Matrix result(n, n + 1);
  result << Matrix::Identity(n, n), Vector::Constant(n, -1);
  return result;
}

/// N points drawn uniformly on the unit sphere about `center`.
inline Matrix sphere_points(std::mt19937_64& random, const Vector& center, Eigen::Index N) {
  std::normal_distribution<double> normal;
  Matrix result(center.size(), N);
  for (Eigen::Index i = 0; i < N; ++i) {
    for (Eigen::Index k = 0; k < center.size(); ++k) result(k, i) = normal(random);
    result.col(i) = result.col(i).normalized() + center;
  }
  return result;
}

/// Example 2: N points on each of two unit spheres of R^n whose centres are 3 apart.
inline Instance two_spheres(std::uint64_t seed, Eigen::Index n, Eigen::Index N) {
  std::mt19937_64 random(seed);
  const Vector direction = sphere_points(random, Vector::Zero(n), 1).col(0);
  return instance(sphere_points(random, 3 * direction, N), sphere_points(random, Vector::Zero(n), N));
}

}  // namespace raygauge::testing
