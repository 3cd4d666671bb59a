// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/cone_program.h"

#include <Eigen/LU>
#include <cmath>

#include "raygauge/exceptions.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/box.h"
#include "raygauge/sets/ellipsoid.h"
#include "raygauge/sets/truncated_cone.h"

namespace raygauge {

/// |F x + f| <= g·x + γ.
struct ConeProgram::Cone {
  Eigen::MatrixXd F;
  Vector f;
  Vector g;
  double gamma = 0;
};

namespace {

using Matrix = Eigen::MatrixXd;

/// 0 <= g·x + γ.
template <class Cone>
Cone half_space(const Vector& g, double gamma) {
  return {Matrix(0, g.size()), Vector(0), g, gamma};
}

template <class Cone>
std::vector<Cone> cones_of_ellipsoid(const Vector& center, const Matrix& factor) {
  const Eigen::Index n = center.size();
  if (factor.cols() != n) return {};
  const Eigen::FullPivLU<Matrix> decomposition(factor);
  if (!decomposition.isInvertible()) return {};
  const Matrix F = decomposition.inverse();
  return {{F, -F * center, Vector::Zero(n), 1}};
}

template <class Cone>
std::vector<Cone> cones_of_box(const Box& box) {
  std::vector<Cone> cones;
  for (int k = 0; k < box.dimension(); ++k) {
    const Vector e = Vector::Unit(box.dimension(), k);
    cones.push_back(half_space<Cone>(e, -box.lower()[k]));
    cones.push_back(half_space<Cone>(-e, box.upper()[k]));
  }
  return cones;
}

template <class Cone>
std::vector<Cone> cones_of_truncated_cone(const TruncatedCone& set) {
  const int n = set.dimension();
  const double height = (set.top() - set.base()).norm();
  const Vector axis = (set.top() - set.base()) / height;
  const Matrix F = Matrix::Identity(n, n) - axis * axis.transpose();
  const Vector g = (set.top_radius() - set.base_radius()) / height * axis;
  return {{F, -F * set.base(), g, set.base_radius() - g.dot(set.base())},
          half_space<Cone>(axis, -axis.dot(set.base())),
          half_space<Cone>(-axis, axis.dot(set.top()))};
}

}  // namespace

std::vector<ConeProgram::Cone> ConeProgram::cones_of(const ConvexSet& set, const std::string& name,
                                                     const std::string& method) {
  std::vector<Cone> cones;
  if (const auto* ellipsoid = dynamic_cast<const Ellipsoid*>(&set)) {
    cones = cones_of_ellipsoid<Cone>(set.center(), ellipsoid->factor());
  } else if (const auto* ball = dynamic_cast<const Ball*>(&set)) {
    const int n = set.dimension();
    cones = cones_of_ellipsoid<Cone>(set.center(), ball->radius() * Matrix::Identity(n, n));
  } else if (const auto* box = dynamic_cast<const Box*>(&set)) {
    cones = cones_of_box<Cone>(*box);
  } else if (const auto* cone = dynamic_cast<const TruncatedCone*>(&set)) {
    cones = cones_of_truncated_cone<Cone>(*cone);
  }
  if (!cones.empty()) return cones;
  throw InvalidParameterError("method '" + method +
                              "' takes ellipsoids and balls that are not flat, boxes and " +
                              "truncated cones only, and " + name + " is none of these");
}

ConeProgram::Constraint ConeProgram::unscaled(const Cone& cone) {
  const Eigen::Index n = cone.g.size();
  Constraint constraint{Matrix::Zero(n + 1, cone.F.rows()), cone.f, Vector::Zero(n + 1), cone.gamma};
  constraint.J_transposed.bottomRows(n) = cone.F.transpose();
  constraint.g.tail(n) = cone.g;
  return constraint;
}

ConeProgram::Constraint ConeProgram::scaled(const Cone& cone) {
  Constraint constraint = unscaled(cone);
  constraint.J_transposed.row(0) = cone.f.transpose();
  constraint.j.setZero();
  constraint.g[0] = cone.gamma;
  constraint.gamma = 0;
  return constraint;
}

ConeProgram::ConeProgram(const Instance& instance, const std::string& method) {
  const int n = instance.A->dimension();
  if (instance.Q->dimension() != n) {
    throw DimensionMismatchError("A lives in R^" + std::to_string(n) + ", Q in R^" +
                                 std::to_string(instance.Q->dimension()));
  }
  variables_ = n + 1;
  for (const Cone& cone : cones_of(*instance.A, "A", method)) constraints_.push_back(unscaled(cone));
  for (const Cone& cone : cones_of(*instance.Q, "Q", method)) constraints_.push_back(scaled(cone));
  start_.resize(variables_);
  start_ << 1, instance.A->support_mapping(-instance.A->center());
  w_.resize(n);
  Jw_.resize(variables_);
  make_start_feasible();
}

double ConeProgram::residual(const Constraint& constraint, const double* y) {
  double square = 0;
  Jw_.setZero();
  for (Eigen::Index row = 0; row < constraint.j.size(); ++row) {
    const double* J = constraint.J_transposed.col(row).data();
    double sum = constraint.j[row];
    for (int k = 0; k < variables_; ++k) sum += J[k] * y[k];
    for (int k = 0; k < variables_; ++k) Jw_[k] += sum * J[k];
    w_[row] = sum;
    square += sum * sum;
  }
  return std::sqrt(square);
}

double ConeProgram::value(int i, const double* y, double* gradient) {
  const Constraint& constraint = constraints_[static_cast<std::size_t>(i)];
  double radius = constraint.gamma;
  for (int k = 0; k < variables_; ++k) radius += constraint.g[k] * y[k];
  const double length = residual(constraint, y);
  if (gradient != nullptr) {
    const double of_w = length > 0 ? 1 / length : 0;
    for (int k = 0; k < variables_; ++k) gradient[k] = of_w * Jw_[k] - constraint.g[k];
  }
  return length - radius;
}

bool ConeProgram::holds(const Vector& y) {
  for (int i = 0; i < constraints(); ++i) {
    if (!(value(i, y.data(), nullptr) <= 0)) return false;
  }
  return true;
}

void ConeProgram::make_start_feasible() {
  constexpr double kLargest = 1e15;
  constexpr double kSmallest = 1e-15;
  constexpr int kHalvings = 20;
  Vector trial = start_;
  while (trial[0] < kLargest && !holds(trial)) trial[0] *= 2;
  if (!holds(trial)) return;  // no multiple of Q reaches the point
  start_ = trial;
  while (trial[0] > kSmallest && holds(trial)) {
    start_ = trial;
    trial[0] /= 2;
  }
  double low = trial[0];
  for (int i = 0; i < kHalvings; ++i) {
    trial[0] = (low + start_[0]) / 2;
    if (holds(trial)) {
      start_ = trial;
    } else {
      low = trial[0];
    }
  }
}

}  // namespace raygauge
