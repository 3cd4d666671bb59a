// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "generators/hard/polytopes.h"

#include <algorithm>
#include <cmath>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

constexpr int kLargestCube = 12;

}  // namespace

ParameterInfo body_parameter(const std::vector<std::string>& choices) {
  return {"body", choices.front(), {}, {}, "the gauge body Q", choices};
}

Body body_of(const Parameters& parameters) {
  const std::string name = string_parameter(parameters, "body");
  if (name == "cube") return Body::cube;
  return name == "simplex" ? Body::simplex : Body::cross_polytope;
}

Eigen::MatrixXd vertices(Body body, int n) {
  if (body == Body::cube) return box(Vector::Zero(n), Vector::Ones(n));
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  if (body == Body::cross_polytope) {
    Eigen::MatrixXd points(n, 2 * n);
    points << identity, -identity;
    return points;
  }
  Eigen::MatrixXd points(n, n + 1);
  points << identity, -Vector::Ones(n);
  return points;
}

double gauge(Body body, const Vector& x) {
  double sum = 0, absolute_sum = 0, largest = 0, smallest = 0;
  for (const double coordinate : x) {
    sum += coordinate;
    absolute_sum += std::abs(coordinate);
    largest = std::max(largest, std::abs(coordinate));
    smallest = std::min(smallest, coordinate);
  }
  switch (body) {
    case Body::cross_polytope:
      return absolute_sum;
    case Body::cube:
      return largest;
    default:
      return sum - static_cast<double>(x.size() + 1) * smallest;
  }
}

Eigen::MatrixXd box(const Vector& center, const Vector& half_width) {
  const auto n = static_cast<int>(center.size());
  if (n > kLargestCube) {
    throw InvalidParameterError("a box in R^n has 2^n vertices: n must be at most " +
                                std::to_string(kLargestCube) + ", got " + std::to_string(n));
  }
  Eigen::MatrixXd points(n, Eigen::Index{1} << n);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (int k = 0; k < n; ++k)
      points(k, i) = center[k] + ((i >> k & 1) != 0 ? half_width[k] : -half_width[k]);
  }
  return points;
}

Eigen::MatrixXd facet_and_apex(int n, double height, double top) {
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(n, 2 * n - 1);
  points.row(0).setConstant(height);
  for (int k = 1; k < n; ++k) {
    points(k, 2 * k - 2) = 1;
    points(k, 2 * k - 1) = -1;
  }
  points(0, 2 * n - 2) = top;
  return points;
}

}  // namespace raygauge
