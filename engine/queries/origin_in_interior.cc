// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/membership.h"

#include <algorithm>
#include <cmath>

#include "engine/kernels/kernel.h"
#include "engine/lp/centred_points.h"
#include "engine/lp/column_pool.h"
#include "engine/lp/gauge_bound.h"
#include "engine/lp/scaling.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/stopwatch.h"
#include "engine/queries/tuning.h"
#include "raygauge/queries/solver.h"

namespace raygauge {
namespace {

// Weights by Newton steps or two linear programs that prove it for most sets with the origin inside. False
// says nothing.
bool surrounds_origin(const PointSet& Q, const Stopwatch& stopwatch) {
  Scaling scaling;
  scaling.compute(Q, Q);
  ColumnPool points;
  points.choose(Q, scaling.factor_Q(), scaling.trivial_Q(), true);
  if (Q.dimension() >= tuned::kManyDimensionsOfOrigin &&
      are_centred(points.view(), Q.dimension(), best_kernels(), stopwatch))
    return true;
  GaugeBound bound;
  return bound.compute(points, Q.dimension(), best_kernels(), stopwatch) < kInfinity;
}

// Generic points first: they find out most sets that leave the origin outside.
Vector target(int which, const Vector& size) {
  const auto n = static_cast<int>(size.size());
  if (which < 2) {
    Vector generic(n);
    for (int k = 0; k < n; ++k) generic[k] = (which == 0 ? size[k] : -size[k]) * generic_coordinate(k);
    return generic;
  }
  const int k = which - 2;
  return k < n ? Vector(size[k] * Vector::Unit(n, k)) : Vector(-size);
}

}  // namespace

OriginInInterior origin_in_interior(const PointSet& Q, double time_limit) {
  using Answer = OriginInInterior::Answer;
  const int n = Q.dimension();
  Vector size(n);
  for (int k = 0; k < n; ++k) {
    const double largest = Q.coordinate_magnitude()[k];
    if (largest == 0) return {Answer::violated, Vector::Unit(n, k)};
    size[k] = std::ldexp(1.0, std::ilogb(largest));
  }
  Stopwatch stopwatch;
  stopwatch.start(time_limit);
  if (stopwatch.expired()) return {};
  if (surrounds_origin(Q, stopwatch)) return {Answer::holds, {}};
  DistanceOptions options;
  options.tolerance = 0.5;  // whether the distance is finite is all that matters
  DistanceSolver solver;
  for (int which = 0; which < n + 3; ++which) {
    if (stopwatch.expired()) return {};
    if (stopwatch.limited()) options.time_limit = std::max(0.0, stopwatch.remaining());
    solver.set_options(options);
    const DistanceResult& result = solver.solve(PointSet(target(which, size)), Q);
    if (result.status == DistanceStatus::unreachable) return {Answer::violated, result.normal};
    if (!std::isfinite(result.upper)) return {};
  }
  return {Answer::holds, {}};
}

}  // namespace raygauge
