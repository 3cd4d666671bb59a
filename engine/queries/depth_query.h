// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "engine/methods/bodies/depth_search.h"
#include "engine/methods/bodies/hull_depth.h"
#include "engine/queries/body_depth.h"
#include "raygauge/methods/options.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {

/// The depth of two objects of R^1 to R^6 in any metric: by BodyDepth where the metric is a ball about the
/// origin and both have fixed-size code, else by their support mappings in doubles. In larger spaces there
/// are bounds only: 0, and the least of a few directions.
class DepthQuery {
 public:
  /// As BodyDepth::set_enough(); of bodies by support mappings it has no effect.
  void set_enough(double gap) noexcept { bodies_.set_enough(gap); }

  /// Of objects that are not proven to be apart. Where `start` is that of an overlap and its normal proves
  /// the objects apart, the result is that of no evaluation. `seconds` of the time limit have been spent
  /// already, or NaN.
  void solve(const Posed& A1, const Posed& A2, const ConvexSet& Q, const DistanceOptions& options,
             const std::function<bool()>& stop, const DepthStart& start, double seconds, ObjectDepth& result);

  /// The last solve, whose answer is `depth`, in R^1 to R^3.
  void record(const ObjectDepth& depth, WarmStart& warm);

  /// Of the last solve, whose answer is `depth`, in a ball: unit vectors along which A1 may be as near to the
  /// outside, beside depth.normal. Replaces what is in `normals`.
  void other_normals(const ObjectDepth& depth, std::vector<Vector3>& normals) const;

 private:
  bool solve_bodies(const Posed& A1, const Posed& A2, double radius, const DistanceOptions& options,
                    const DepthStart& start, ObjectDepth& result);
  void solve_sets(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
                  const double* start, ObjectDepth& result);
  void solve_hull(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
                  const double* start, ObjectDepth& result);
  static void bound_along_axes(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q,
                               ObjectDepth& result);

  BodyDepth bodies_;
  bool by_bodies_ = false;
  BodyDepthAnswer answer_;
  DepthSearch<double> search_;
  HullDepth hull_;
  Stopwatch watch_;
};

}  // namespace raygauge
