// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/continuous.h"

#include "scene/queries/effects.h"
#include "scene/queries/pair_solver.h"

namespace raygauge {

ContinuousSolver::ContinuousSolver(int dimension) : solver_(std::make_unique<PairSolver>(dimension)) {}

ContinuousSolver::~ContinuousSolver() = default;

ImpactResult ContinuousSolver::time_of_impact(const Body& a, const Body& b,
                                              const ContinuousOptions& options) {
  return raygauge::time_of_impact(*solver_, a, b, options);
}

ClearanceResult ContinuousSolver::clearance(const Body& a, const Body& b, const SceneMetric& metric,
                                            const Body* metric_body, const ContinuousOptions& options) {
  return raygauge::clearance(*solver_, a, b, metric, metric_body, options);
}

const SceneCounters& ContinuousSolver::counters() const noexcept { return solver_->counters(); }

}  // namespace raygauge
