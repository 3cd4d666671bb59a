// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "raygauge/methods/options.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// Computes how deep the origin is in a set D, measured by Q,
///
///     depth_Q(D) = max{t >= 0 : tQ ⊆ D} = min{h_D(u)/h_Q(u) : u != 0},
///
/// of any sets of R^1 to R^6, by their support mappings alone: see ObjectDepth, with A1 = {0} and A2 = D.
/// With the wrenches that a grasp can exert for D it is the grasp quality of Ferrari & Canny ("Planning
/// optimal grasps", 1992), see GraspWrenches. It is 0 if the origin is outside of D or on its boundary. In
/// larger spaces there are bounds only, 0 and the least of 2n directions.
///
/// The method is that of expanding polytopes; 4 to 6 dimensions take up to 200 MB for hard curved sets, and
/// end with `iteration_limit` there. One solver per thread; a repeated solve of the same size allocates
/// nothing.
class DepthSolver {
 public:
  /// Tolerance and limits. Throws InvalidParameterError for an option outside its range.
  explicit DepthSolver(const DistanceOptions& options = {});
  ~DepthSolver();
  DepthSolver(DepthSolver&&) noexcept;
  DepthSolver& operator=(DepthSolver&&) noexcept;

  /// See DistanceSolver::set_stop.
  void set_stop(std::function<bool()> stop);

  /// The result belongs to the solver and lives until its next solve. With `normal` u and q the support point
  /// of Q for it, `point_2` is the point of D where the ray along q leaves it: depth q, to the gap. Throws
  /// DimensionMismatchError.
  const ObjectDepth& solve(const ConvexSet& D, const ConvexSet& Q);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace raygauge
