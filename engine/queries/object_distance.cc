// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <cmath>
#include <utility>

#include "engine/queries/method_chain.h"
#include "engine/queries/spatial_query.h"
#include "engine/sets/object_pair.h"
#include "engine/sets/parameters.h"
#include "engine/sets/posed_view.h"

namespace raygauge {

struct ObjectDistanceSolver::Workspace {
  explicit Workspace(const DistanceOptions& options) : methods(options) {}

  MethodChain methods;
  SupportPairs pairs;
  WeightedPoints combination;
  ObjectDistance result;
  SpatialQuery spatial;

  void add_gradients(ObjectEffects effects);
  void find_closest_points(int n);
};

// Every point of the combination is a difference that was asked for on the way, and its parts were noted.
void ObjectDistanceSolver::Workspace::find_closest_points(int n) {
  double sum = 0;
  for (int i = 0; i < combination.count(); ++i) sum += combination.weight(i);
  result.closest_point_1.setZero(n);
  result.closest_point_2.setZero(n);
  for (int i = 0; i < combination.count(); ++i) {
    const double weight = combination.weight(i) / sum;
    const double* difference = combination.point(i);
    const double* a1 = pairs.partner(difference);
    for (int k = 0; k < n; ++k) {
      result.closest_point_1[k] += weight * a1[k];
      result.closest_point_2[k] += weight * (a1[k] + difference[k]);
    }
  }
  ++result.closest_point_evaluations;
}

void ObjectDistanceSolver::Workspace::add_gradients(ObjectEffects effects) {
  const bool apart = result.distance.lower > 0 && std::isfinite(result.distance.upper);
  if (has_effect(effects, ObjectEffects::gradient) && apart) {
    result.gradient_1 = result.distance.normal;
    result.gradient_2 = -result.distance.normal;
    ++result.gradient_evaluations;
  } else {
    result.gradient_1.resize(0);
    result.gradient_2.resize(0);
  }
}

ObjectDistanceSolver::ObjectDistanceSolver(const DistanceOptions& options)
    : workspace_(std::make_unique<Workspace>(options)) {}

ObjectDistanceSolver::~ObjectDistanceSolver() = default;
ObjectDistanceSolver::ObjectDistanceSolver(ObjectDistanceSolver&&) noexcept = default;
ObjectDistanceSolver& ObjectDistanceSolver::operator=(ObjectDistanceSolver&&) noexcept = default;

void ObjectDistanceSolver::set_stop(std::function<bool()> stop) {
  workspace_->methods.set_stop(std::move(stop));
}

const ObjectDistance& ObjectDistanceSolver::solve(const ConvexSet& A1, const ConvexSet& A2,
                                                  const ConvexSet& Q, ObjectEffects effects) {
  return solve(Posed(A1), Posed(A2), Q, effects, nullptr);
}

const ObjectDistance& ObjectDistanceSolver::solve(const Posed& posed_1, const Posed& posed_2,
                                                  const ConvexSet& Q, ObjectEffects effects,
                                                  WarmStart* warm) {
  if (posed_1.dimension() == posed_2.dimension() &&
      workspace_->spatial.distance(posed_1, posed_2, Q, workspace_->methods.options(), effects, warm,
                                   workspace_->result)) {
    workspace_->add_gradients(effects);
    return workspace_->result;
  }
  const InPose in_pose_1(posed_1), in_pose_2(posed_2);
  const ConvexSet& A1 = in_pose_1.set();
  const ConvexSet& A2 = in_pose_2.set();
  Workspace& workspace = *workspace_;
  ObjectDistance& result = workspace.result;
  const bool closest_points = has_effect(effects, ObjectEffects::closest_points);
  const int n = A2.dimension();
  const ObjectPair pair(A2, A1, closest_points);
  check_dimension("distance", "Q", Q.dimension(), n);
  if (closest_points) workspace.pairs.begin(pair);
  Aim aim;
  aim.pairs = closest_points ? &workspace.pairs : nullptr;
  result.distance = workspace.methods.solve(Posed(pair), Posed(Q), Effects::none, warm, aim);
  result.closest_point_evaluations = result.gradient_evaluations = 0;
  const bool apart = result.distance.lower > 0 && std::isfinite(result.distance.upper);
  if (closest_points && apart &&
      workspace.methods.nearest_points(result.closest_point_1, result.closest_point_2)) {
    ++result.closest_point_evaluations;
  } else if (closest_points && apart && workspace.methods.contact_combination(workspace.combination)) {
    workspace.find_closest_points(n);
  } else {
    result.closest_point_1.resize(0);
    result.closest_point_2.resize(0);
  }
  workspace.add_gradients(effects);
  return result;
}

}  // namespace raygauge
