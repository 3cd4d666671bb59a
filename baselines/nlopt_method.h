// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `nlopt_slsqp`: the convex program (5) in (λ, x), ConeProgram, by NLopt's sequential quadratic
/// programming (Kraft's SLSQP, the closest relative of the paper's active-set solver). Gradients are exact.
/// Parameters (docs/baselines.md has the reasons):
///
///     constraint_tolerance  1e-12     of each constraint, absolute, as in the paper
///     max_evaluations       1000      of the constraints
///
/// A solve ends as the paper's does: when λ changes by no more than ε |λ| between two evaluations (ε: the
/// request's tolerance) at a point that is within the constraint tolerance. Where rounding stops NLopt
/// before, the status is precision_limit, and `distance` what it had reached. A time limit is wall time. The
/// bounds of the result are NaN: NLopt returns no multipliers, and a point that is feasible to 1e-12 proves
/// nothing. DistanceCounters::pivots counts evaluations.
void register_nlopt_method(MethodRegistry& registry);

/// "2.7.1", of the library that is linked.
std::string nlopt_library_version();

}  // namespace raygauge
