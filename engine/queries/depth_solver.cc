// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "engine/queries/depth_query.h"
#include "engine/sets/parameters.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/sets/ball.h"

namespace raygauge {

class DepthSolver::Work {
 public:
  explicit Work(const DistanceOptions& options) : options_(options) {}

  const ObjectDepth& solve(const ConvexSet& D, const ConvexSet& Q) {
    const int n = D.dimension();
    check_dimension("depth", "Q", Q.dimension(), n);
    if (!origin_ || origin_->dimension() != n) origin_.emplace(Vector::Zero(n), 0.0);
    query_.solve(*origin_, D, Q, options_, stop_, {}, std::numeric_limits<double>::quiet_NaN(), depth_);
    return depth_;
  }

  void set_stop(std::function<bool()> stop) { stop_ = std::move(stop); }

 private:
  DistanceOptions options_;
  std::function<bool()> stop_;
  DepthQuery query_;
  std::optional<Ball> origin_;
  ObjectDepth depth_;
};

DepthSolver::DepthSolver(const DistanceOptions& options) {
  if (const std::string problem = validate(options); !problem.empty()) throw InvalidParameterError(problem);
  work_ = std::make_unique<Work>(options);
}

DepthSolver::~DepthSolver() = default;
DepthSolver::DepthSolver(DepthSolver&&) noexcept = default;
DepthSolver& DepthSolver::operator=(DepthSolver&&) noexcept = default;

void DepthSolver::set_stop(std::function<bool()> stop) { work_->set_stop(std::move(stop)); }

const ObjectDepth& DepthSolver::solve(const ConvexSet& D, const ConvexSet& Q) { return work_->solve(D, Q); }

}  // namespace raygauge
