// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/membership.h"

#include <optional>

#include "engine/queries/growth_body.h"
#include "engine/queries/point_gauges.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/parameters.h"
#include "engine/sets/posed_view.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

DistanceOptions options_of_membership(const ConvexSet& S, double tolerance) {
  DistanceOptions options;
  options.tolerance = tolerance;
  if (S.structure() == SupportStructure::smooth) options.method = DistanceMethod::newton;
  return options;
}

GaugeBounds gauge(const ConvexSet& S, const ConstVectorRef& x, double tolerance) {
  check_dimension("gauge", "x", x.size(), S.dimension());
  const Vector at = checked_finite("gauge", "x", x);
  const PointView point({at.data(), nullptr}, S.dimension());
  const PointSet* points = as_point_set(S);
  std::optional<PointSet> alone;
  if (points != nullptr) alone.emplace(Eigen::MatrixXd(at));
  DistanceSolver solver(options_of_membership(S, tolerance));
  const DistanceResult& result = alone ? solver.solve(*alone, S) : solver.solve(point, S);
  GaugeBounds bounds{result.lower, result.upper};
  Vector normal(S.dimension());
  const double formula = gauge_bound(S, at.data(), normal.data());
  if (formula >= bounds.lower && formula < bounds.upper) bounds.upper = formula;
  return bounds;
}

// Both sets are seen from c: the bounds cover the rounding errors of the shift.
Membership contains(const ConvexSet& S, const ConstVectorRef& x, double tolerance) {
  const int n = S.dimension();
  check_dimension("contains", "x", x.size(), n);
  const Vector at = checked_finite("contains", "x", x);
  const Pose from_center(Eigen::MatrixXd::Identity(n, n), -S.center());
  const PointView point({at.data(), nullptr}, n);
  DistanceSolver solver(options_of_membership(S, tolerance));
  const DistanceResult& result = solver.solve(Posed(point, from_center), Posed(S, from_center));
  if (result.lower > 1) return Membership::outside;
  return result.upper <= 1 ? Membership::inside : Membership::undecided;
}

}  // namespace raygauge
