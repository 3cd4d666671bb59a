// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/similarities.h"

#include <cmath>
#include <utility>

#include "generators/hard/maps.h"

namespace raygauge {
namespace {

// Rows i and j of 5^k times an orthogonal matrix become those of 5^(k+1) times another.
void turn_rows(Eigen::MatrixXd& M, Eigen::Index i, Eigen::Index j, RandomStream& stream) {
  const double side = random_integer(stream, 3, 4);
  const double other = signed_integer(stream, 1, 1) * (7 - side);
  const Eigen::RowVectorXd row = M.row(i);
  M.row(i) = side * row - other * M.row(j);
  M.row(j) = other * row + side * M.row(j);
}

}  // namespace

double on_grid(double x) { return std::round(x * 0x1p36) * 0x1p-36; }

Eigen::MatrixXd integer_similarity(RandomStream& stream, int n, int layers) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Identity(n, n);
  for (int layer = 0; layer < layers; ++layer) {
    const auto order = stream.permutation(n);
    for (std::size_t k = 0; k + 1 < order.size(); k += 2) turn_rows(M, order[k], order[k + 1], stream);
    if (n % 2 == 1) M.row(order.back()) *= signed_integer(stream, 5, 5);
  }
  return M;
}

HalfPlane random_half_plane(RandomStream& stream, int n, int axis_layers, int layers_across) {
  const Eigen::MatrixXd M = integer_similarity(stream, n, axis_layers);
  const Vector w = integer_similarity(stream, n - 1, layers_across).col(0);
  HalfPlane plane{Vector::Zero(n), Vector::Zero(n), 1};
  for (int layer = 0; layer < layers_across; ++layer) plane.unit *= 5;
  plane.along = plane.unit * M.col(0);
  for (Eigen::Index j = 0; j + 1 < n; ++j) plane.across += w[j] * M.col(j + 1);
  for (int layer = 0; layer < axis_layers; ++layer) plane.unit *= 5;
  return plane;
}

}  // namespace raygauge
