// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/growth_distance.h"

#include <algorithm>
#include <limits>
#include <string>

#include "engine/exceptions.h"
#include "engine/queries/growth_body.h"
#include "engine/sets/posed_view.h"

namespace raygauge {

DistanceOptions GrowthDistanceSolver::newton_options() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  return options;
}

GrowthDistanceSolver::GrowthDistanceSolver(const DistanceOptions& options) : solver_(options) {}

// A is scaled about its centre, Q about center_Q_.
const DistanceResult& GrowthDistanceSolver::solve_about(const ConvexSet& A, const ConvexSet& Q,
                                                        double threshold, WarmStart* warm) {
  const int n = A.dimension();
  const auto size = static_cast<std::size_t>(n);
  center_A_.resize(size);
  ray_.resize(size);
  A.center_unchecked(center_A_.data());
  for (std::size_t k = 0; k < size; ++k) ray_[k] = center_A_[k] - center_Q_[k];
  const GrowthBody body(A, center_A_.data(), Q, center_Q_.data());
  solver_.set_threshold(threshold);
  const PointView ray(ray_.data(), n);
  return solver_.solve(Posed(ray), Posed(body), Effects::none, warm);
}

const DistanceResult& GrowthDistanceSolver::solve(const ConvexSet& A, const ConvexSet& Q) {
  return solve(Posed(A), Posed(Q));
}

const DistanceResult& GrowthDistanceSolver::solve(const Posed& A, const Posed& Q, WarmStart* warm) {
  if (A.dimension() != Q.dimension()) {
    throw DimensionMismatchError("growth distance: A lives in R^" + std::to_string(A.dimension()) +
                                 ", Q in R^" + std::to_string(Q.dimension()));
  }
  center_Q_.resize(static_cast<std::size_t>(A.dimension()));
  std::fill_n(center_Q_.data(), A.dimension(), 0.0);
  const InPose in_pose_A(A), in_pose_Q(Q);
  return solve_about(in_pose_A.set(), in_pose_Q.set(), std::numeric_limits<double>::quiet_NaN(), warm);
}

const SeparationResult& GrowthDistanceSolver::separation(const ConvexSet& A1, const ConvexSet& A2) {
  return separation(Posed(A1), Posed(A2));
}

const SeparationResult& GrowthDistanceSolver::separation(const Posed& A1, const Posed& A2, WarmStart* warm) {
  if (A1.dimension() != A2.dimension()) {
    throw DimensionMismatchError("separation: A1 lives in R^" + std::to_string(A1.dimension()) +
                                 ", A2 in R^" + std::to_string(A2.dimension()));
  }
  center_Q_.resize(static_cast<std::size_t>(A1.dimension()));
  const InPose in_pose_1(A1), in_pose_2(A2);
  in_pose_1.set().center_unchecked(center_Q_.data());
  const DistanceResult& growth = solve_about(in_pose_2.set(), in_pose_1.set(), 1.0, warm);
  separation_.lower = growth.lower;
  separation_.upper = growth.upper;
  separation_.counters = growth.counters;
  separation_.outcome = Separation::undecided;
  if (growth.lower > 1) separation_.outcome = Separation::separated;
  if (growth.upper < 1) separation_.outcome = Separation::intersecting;
  if (separation_.outcome == Separation::separated) {
    separation_.normal = growth.normal;
  } else {
    separation_.normal.resize(0);
  }
  return separation_;
}

}  // namespace raygauge
