// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/growth_distance.h"

#include <utility>

#include "engine/queries/ladder.h"
#include "engine/sets/parameters.h"

namespace raygauge {

DistanceOptions GrowthDistanceSolver::newton_options() {
  DistanceOptions options;
  options.method = DistanceMethod::newton;
  return options;
}

GrowthDistanceSolver::GrowthDistanceSolver(const DistanceOptions& options)
    : ladder_(std::make_unique<Ladder>(options)) {}

GrowthDistanceSolver::~GrowthDistanceSolver() = default;
GrowthDistanceSolver::GrowthDistanceSolver(GrowthDistanceSolver&&) noexcept = default;
GrowthDistanceSolver& GrowthDistanceSolver::operator=(GrowthDistanceSolver&&) noexcept = default;

void GrowthDistanceSolver::set_stop(std::function<bool()> stop) { ladder_->set_stop(std::move(stop)); }

const DistanceResult& GrowthDistanceSolver::solve(const ConvexSet& A, const ConvexSet& Q) {
  return solve(Posed(A), Posed(Q));
}

const DistanceResult& GrowthDistanceSolver::solve(const Posed& A, const Posed& Q, WarmStart* warm,
                                                  PoseGradient* gradient) {
  check_dimension("growth distance", "Q", Q.dimension(), A.dimension());
  Ask ask(Question::growth, Q, A, warm);
  ask.about_origin = true;
  ask.pose_gradient = gradient;
  return ladder_->growth(ask);
}

const DistanceResult& GrowthDistanceSolver::solve_about_centers(const Posed& A1, const Posed& A2,
                                                                WarmStart* warm, PoseGradient* gradient) {
  check_dimension("growth distance", "A2", A2.dimension(), A1.dimension());
  Ask ask(Question::growth, A1, A2, warm);
  ask.pose_gradient = gradient;
  return ladder_->growth(ask);
}

const SeparationResult& GrowthDistanceSolver::separation(const ConvexSet& A1, const ConvexSet& A2) {
  return separation(Posed(A1), Posed(A2));
}

const SeparationResult& GrowthDistanceSolver::separation(const Posed& A1, const Posed& A2, WarmStart* warm) {
  check_dimension("separation", "A2", A2.dimension(), A1.dimension());
  Ask ask(Question::separation, A1, A2, warm);
  return ladder_->separation(ask);
}

}  // namespace raygauge
