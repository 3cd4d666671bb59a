// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/queries/facet_walks.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// For gauges of S at points.
DistanceOptions options_of_membership(const ConvexSet& S, double tolerance);

/// Bounds of the gauges of a set at some columns of X: by walks over the facets of a hull of points where
/// they are many, by single solves otherwise. Solvers and facets are kept.
class PointGauges {
 public:
  using Points = Eigen::Ref<const Eigen::MatrixXd>;
  using Indices = std::vector<std::size_t>;  // columns

  PointGauges(const ConvexSet& S, const PointsOptions& options);

  /// Whether it may walk over the facets of S for so many points.
  static bool may_walk(const ConvexSet& S, std::ptrdiff_t points) noexcept;

  /// The gauges of X's columns `which`; both sets in `pose`, if there is one. Normals, of n doubles, if
  /// asked.
  void solve(const Points& X, const Indices& which, const Pose* pose, bool with_normals);

  std::vector<double> lower, upper, normal;

  /// At least max(gauge(e_k), gauge(-e_k)), +infinity where it is; measured once.
  const Vector& axis_gauges();

 private:
  void solve_alone(const Points& X, const Indices& which, const Indices& at, const Pose* pose,
                   bool with_normals);
  bool walks_begin(const Points& X, const Indices& which, Indices& rest);
  void walk(const Points& X, const Indices& which, Indices& rest, bool with_normals);

  const ConvexSet* S_;
  PointsOptions options_;
  PairBatch batch_;
  std::vector<std::optional<PointSet>> points_;  // of each thread
  Vector axis_gauges_;                           // empty: not measured
  std::optional<FacetWalks> walks_;
  bool may_walk_;
  std::vector<double> lower_, upper_, normal_;  // of the solves of a batch
  std::vector<WalkAnswer> walked_;
};

}  // namespace raygauge
