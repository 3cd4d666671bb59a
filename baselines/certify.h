// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "baselines/gauge_lp.h"
#include "engine/distance/result.h"

namespace raygauge {

/// What a linear-programming solver leaves behind: its own claim, taken on trust by nobody.
struct LpAnswer {
  DistanceStatus status = DistanceStatus::precision_limit;
  double objective = DistanceResult::kUnset;  ///< Σβ_j as the solver reports it
  std::int64_t pivots = 0;
  std::vector<double> primal;  ///< α then β, lp.columns() values; empty where the solver has none
  Vector u;                    ///< duals of the first n rows; empty where the solver has none
};

/// The answer as a DistanceResult: `distance` and `status` are the solver's own claim, untouched (+inf for
/// unreachable), while `lower` and `upper` are certified by raygauge,
///
///     lower = -h_A(u) / h_Q(-u)   from the duals, by weak duality,
///     upper = Σβ_j                of a combination that is feasible, made from the primal.
///
/// A bound is NaN where the solver left nothing that proves one.
DistanceResult certified_result(const GaugeLp& lp, const LpAnswer& answer);

}  // namespace raygauge
