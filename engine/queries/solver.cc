// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/solver.h"

#include <string>
#include <utility>

#include "engine/queries/ladder.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {

DistanceMethod method_for(const ConvexSet& Q) noexcept {
  return Q.structure() == SupportStructure::smooth ? DistanceMethod::newton
                                                   : DistanceMethod::column_generation;
}

DistanceSolver::DistanceSolver(const DistanceOptions& options) : ladder_(std::make_unique<Ladder>(options)) {}

DistanceSolver::~DistanceSolver() = default;
DistanceSolver::DistanceSolver(DistanceSolver&&) noexcept = default;
DistanceSolver& DistanceSolver::operator=(DistanceSolver&&) noexcept = default;

const DistanceOptions& DistanceSolver::options() const noexcept { return ladder_->options(); }

void DistanceSolver::set_options(const DistanceOptions& options) { ladder_->set_options(options); }

void DistanceSolver::set_stop(std::function<bool()> stop) { ladder_->set_stop(std::move(stop)); }

const DistanceResult& DistanceSolver::solve(const ConvexSet& A, const ConvexSet& Q, Effects effects) {
  if (A.dimension() != Q.dimension()) {
    throw DimensionMismatchError("A lives in R^" + std::to_string(A.dimension()) + ", Q in R^" +
                                 std::to_string(Q.dimension()));
  }
  Ask ask(Question::gauge, A, Q, nullptr);
  ask.effects = effects;
  return ladder_->gauge(ask);
}

const DistanceResult& DistanceSolver::solve(const Posed& A, const Posed& Q, Effects effects,
                                            WarmStart* warm) {
  check_dimension("distance", "Q", Q.dimension(), A.dimension());
  Ask ask(Question::gauge, A, Q, warm);
  ask.effects = effects;
  return ladder_->gauge(ask);
}

}  // namespace raygauge
