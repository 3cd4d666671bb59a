// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/scene/continuous.h"
#include "scene/queries/pair_solver.h"

namespace raygauge {

/// As of ContinuousSolver, by a solver that is bound anew.
ImpactResult time_of_impact(PairSolver& solver, const Body& a, const Body& b,
                            const ContinuousOptions& options);
ClearanceResult clearance(PairSolver& solver, const Body& a, const Body& b, const SceneMetric& metric,
                          const Body* metric_body, const ContinuousOptions& options);

}  // namespace raygauge
