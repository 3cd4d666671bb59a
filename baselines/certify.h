// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "baselines/gauge_lp.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// What a linear-programming solver leaves behind: its own claim, taken on trust by nobody.
struct LpAnswer {
  DistanceStatus status = DistanceStatus::precision_limit;
  double objective = DistanceResult::kUnset;  ///< Σβ_j as the solver reports it
  std::int64_t pivots = 0;
  std::vector<std::ptrdiff_t> basis;  ///< its final basis: columns of GaugeLp; empty where it has none
  Vector u;                           ///< duals of the first n rows; empty where it has none
};

/// The answer as a DistanceResult: `distance` and `status` are the solver's own claim, untouched (+inf for
/// unreachable), while `lower` and `upper` are certified by raygauge,
///
///     lower = -h_A(u) / h_Q(-u)   from the duals, by weak duality,
///     upper = Σβ_j                of the best feasible combination of the basic points.
///
/// A bound is NaN where the solver left nothing to make it from; `upper` is +inf where 2 s do not prove one.
/// `normal` is u, scaled to h_Q(-normal) = 1 where that is possible.
DistanceResult certified_result(const GaugeLp& lp, const LpAnswer& answer);

}  // namespace raygauge
