// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/tangent_plane/tangent_plane.h"

#include "engine/numerics/floating_point.h"
#include "engine/sets/capability_queries.h"

namespace raygauge {

bool TangentPlane::solve(const Problem& problem, DistanceResult& result) {
  const int n = problem.A.dimension();
  normal_.reserve(2 * static_cast<std::size_t>(n));
  double* u = normal_.data();
  if (!touches_origin(problem.Q, u)) return false;
  oracle_A_.bind(problem.A, nullptr, kernels_for(problem.options.instruction_set));
  if (oracle_A_.verify(u, -1.0, kInfinity, u + n).above() > 0) return false;
  result.status = DistanceStatus::unreachable;
  result.distance = result.lower = result.upper = kInfinity;
  result.normal = -Vector::Map(u, n);
  result.room_for_contact(problem.effects, n);  // for none
  return true;
}

}  // namespace raygauge
