// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/solver.h"

#include <string>
#include <utility>

#include "engine/queries/method_chain.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"

namespace raygauge {

DistanceMethod method_for(const ConvexSet& Q) noexcept {
  return Q.structure() == SupportStructure::smooth ? DistanceMethod::newton
                                                   : DistanceMethod::column_generation;
}

DistanceSolver::DistanceSolver(const DistanceOptions& options)
    : methods_(std::make_unique<MethodChain>(options)) {}

DistanceSolver::~DistanceSolver() = default;
DistanceSolver::DistanceSolver(DistanceSolver&&) noexcept = default;
DistanceSolver& DistanceSolver::operator=(DistanceSolver&&) noexcept = default;

const DistanceOptions& DistanceSolver::options() const noexcept { return methods_->options(); }

void DistanceSolver::set_options(const DistanceOptions& options) { methods_->set_options(options); }

void DistanceSolver::set_stop(std::function<bool()> stop) { methods_->set_stop(std::move(stop)); }

const DistanceResult& DistanceSolver::solve(const ConvexSet& A, const ConvexSet& Q, Effects effects) {
  if (A.dimension() != Q.dimension()) {
    throw DimensionMismatchError("A lives in R^" + std::to_string(A.dimension()) + ", Q in R^" +
                                 std::to_string(Q.dimension()));
  }
  return methods_->solve(A, Q, effects);
}

const DistanceResult& DistanceSolver::solve(const Posed& A, const Posed& Q, Effects effects,
                                            WarmStart* warm) {
  check_dimension("distance", "Q", Q.dimension(), A.dimension());
  return methods_->solve(A, Q, effects, warm);
}

}  // namespace raygauge
