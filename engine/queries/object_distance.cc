// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <cmath>
#include <utility>

#include "engine/queries/formula_distance.h"
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

const ObjectDistance& distance_by_search(Ladder& ladder, const Posed& A1, const Posed& A2, const ConvexSet& Q,
                                         ObjectEffects effects, WarmStart* warm) {
  Ask ask(Question::distance, A1, A2, warm);
  ask.metric = &Q;
  ask.object_effects = effects;
  ObjectDistance& result = ladder.distance(ask);
  add_gradients(effects, result);
  return result;
}

const ObjectDistance& distance_of_objects(Ladder& ladder, const Posed& A1, const Posed& A2,
                                          const ConvexSet& Q, ObjectEffects effects, WarmStart* warm) {
  if (has_effect(effects, ObjectEffects::pose_gradient)) effects = effects | ObjectEffects::closest_points;
  const bool by_search = warm != nullptr && warm->overlap;  // the depth of before
  if (by_search || !is_open_to_bodies(ladder.options()))
    return distance_by_search(ladder, A1, A2, Q, effects, warm);
  return distance_by_formula(ladder, A1, A2, Q, effects, warm);
}

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
  return distance_of_objects(*ladder_, A1, A2, Q, effects, warm);
}

}  // namespace raygauge
