// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/origin_in_interior.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/stopwatch.h"
#include "engine/queries/solver.h"

namespace raygauge {

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
  DistanceOptions options;
  options.tolerance = 0.5;  // whether the distance is finite is all that matters
  DistanceSolver solver;
  for (int k = 0; k <= n; ++k) {
    if (stopwatch.expired()) return {};
    if (stopwatch.limited()) options.time_limit = std::max(0.0, time_limit - stopwatch.seconds());
    solver.set_options(options);
    const PointSet target(k < n ? Vector(size[k] * Vector::Unit(n, k)) : Vector(-size));
    const DistanceResult& result = solver.solve(target, Q);
    if (result.status == DistanceStatus::unreachable) return {Answer::violated, result.normal};
    if (!std::isfinite(result.upper)) return {};
  }
  return {Answer::holds, {}};
}

}  // namespace raygauge
