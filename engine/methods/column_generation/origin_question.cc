// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/origin_question.h"

#include <algorithm>
#include <cmath>

#include "engine/sets/object_pair.h"
#include "raygauge/sets/operations.h"

namespace raygauge {
namespace {

// A power of two of about the size of the coordinates, in every dimension; 1 where they are zero.
Vector sizes(const PointSet& S) {
  Vector size = Vector::Ones(S.dimension());
  for (int k = 0; k < S.dimension(); ++k) {
    const double largest = S.coordinate_magnitude()[k];
    if (largest > 0) size[k] = std::ldexp(1.0, std::ilogb(largest));
  }
  return size;
}

PointSet cross_polytope(const Vector& size) {
  const auto n = size.size();
  Eigen::MatrixXd vertices(n, 2 * n);
  vertices << Eigen::MatrixXd(size.asDiagonal()), -Eigen::MatrixXd(size.asDiagonal());
  return PointSet(vertices);
}

// S × {height}.
PointSet lifted(const PointSet& S, double height) {
  const int n = S.dimension();
  Eigen::MatrixXd points(n + 1, S.size());
  for (std::ptrdiff_t i = 0; i < S.size(); ++i) {
    S.copy_point(i, points.col(i).data());
    points(n, i) = height;
  }
  return PointSet(points);
}

// The two sets whose difference A is; nullptr where it is none of point sets.
struct Operands {
  const PointSet* A2 = nullptr;
  const PointSet* A1 = nullptr;
  bool both() const { return A2 != nullptr && A1 != nullptr; }
};

Operands operands(const ConvexSet& A) {
  if (const auto* sets = dynamic_cast<const MinkowskiDifference*>(&A))
    return {as_point_set(*sets->A2()), as_point_set(*sets->A1())};
  if (const auto* pair = dynamic_cast<const ObjectPair*>(&A))
    return {as_point_set(pair->A2()), as_point_set(pair->A1())};
  return {};
}

// Of any point that is found, however far apart the bounds are.
DistanceOptions loosely(const DistanceOptions& options) {
  constexpr double kLoose = 0.5;
  DistanceOptions loose = options;
  loose.tolerance = kLoose;
  loose.max_iterations = 0;
  return loose;
}

}  // namespace

bool OriginQuestion::solve(const Problem& problem, DistanceResult& result) {
  answer_.counters = {};
  answer_.origin_weights.clear();
  if (problem.stopwatch.expired()) return false;
  if (const PointSet* A = as_point_set(problem.A)) {
    if (!is_in_points(*A, problem)) return false;
  } else {
    const Operands sets = operands(problem.A);
    if (!sets.both() || !meet(*sets.A2, *sets.A1, problem)) return false;
  }
  const int n = problem.A.dimension();
  result.status = DistanceStatus::contains_origin;
  result.distance = result.lower = result.upper = 0;
  result.origin_weights = answer_.origin_weights;
  result.normal = answer_.normal.head(n);
  if (double* contact = result.room_for_contact(problem.effects, n)) {
    std::fill_n(contact, n, 0.0);
    ++answer_.counters.witness_evaluations;
  }
  return true;
}

bool OriginQuestion::is_in_points(const PointSet& A, const Problem& problem) {
  const PointSet C = cross_polytope(sizes(A));
  sifting_.solve(A, C, loosely(problem.options), problem.stopwatch, Effects::none, answer_);
  return answer_.status == DistanceStatus::contains_origin;
}

bool OriginQuestion::meet(const PointSet& A2, const PointSet& A1, const Problem& problem) {
  const double height = sizes(A1).maxCoeff();
  sifting_.solve(lifted(A2, height), lifted(A1, height), loosely(problem.options), problem.stopwatch,
                 Effects::none, answer_);
  answer_.origin_weights.clear();
  return answer_.upper < std::numeric_limits<double>::infinity();
}

}  // namespace raygauge
