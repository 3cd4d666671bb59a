// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <cmath>
#include <utility>

#include "engine/queries/ladder.h"

namespace raygauge {
namespace {

void add_gradients(ObjectEffects effects, ObjectDistance& result) {
  const bool apart = result.distance.lower > 0 && std::isfinite(result.distance.upper);
  const bool inside = result.depth.evaluations > 0 && result.depth.normal.size() > 0;
  if (has_effect(effects, ObjectEffects::gradient) && (apart || inside)) {
    result.gradient_1 = apart ? result.distance.normal : result.depth.normal;
    result.gradient_2 = -result.gradient_1;
    ++result.gradient_evaluations;
  } else {
    result.gradient_1.resize(0);
    result.gradient_2.resize(0);
  }
}

}  // namespace

ObjectDistanceSolver::ObjectDistanceSolver(const DistanceOptions& options)
    : ladder_(std::make_unique<Ladder>(options)) {}

ObjectDistanceSolver::~ObjectDistanceSolver() = default;
ObjectDistanceSolver::ObjectDistanceSolver(ObjectDistanceSolver&&) noexcept = default;
ObjectDistanceSolver& ObjectDistanceSolver::operator=(ObjectDistanceSolver&&) noexcept = default;

void ObjectDistanceSolver::set_stop(std::function<bool()> stop) { ladder_->set_stop(std::move(stop)); }

const ObjectDistance& ObjectDistanceSolver::solve(const ConvexSet& A1, const ConvexSet& A2,
                                                  const ConvexSet& Q, ObjectEffects effects) {
  return solve(Posed(A1), Posed(A2), Q, effects, nullptr);
}

const ObjectDistance& ObjectDistanceSolver::solve(const Posed& A1, const Posed& A2, const ConvexSet& Q,
                                                  ObjectEffects effects, WarmStart* warm) {
  if (has_effect(effects, ObjectEffects::pose_gradient)) effects = effects | ObjectEffects::closest_points;
  ObjectDistance& result = ladder_->distance(A1, A2, Q, effects, warm);
  add_gradients(effects, result);
  return result;
}

}  // namespace raygauge
