// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/queries/depth_query.h"
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
  DepthQuery depth;
  std::array<double, 3> start{};  // of the depth
  bool has_start = false, had_depth = false;

  void begin(const Posed& A1, ObjectEffects effects, const WarmStart* warm);
  void find_depth(const Posed& A1, const Posed& A2, const ConvexSet& Q, WarmStart* warm);
  bool meet_in_depth(const Posed& A1, const Posed& A2, const ConvexSet& Q, ObjectEffects effects,
                     WarmStart* warm);
  void add_depth(const Posed& A1, const Posed& A2, const ConvexSet& Q, ObjectEffects effects,
                 WarmStart* warm);
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

// The distance writes over the normal of the solve before.
void ObjectDistanceSolver::Workspace::begin(const Posed& A1, ObjectEffects effects, const WarmStart* warm) {
  had_depth = result.depth.evaluations > 0;
  result.depth.evaluations = 0;
  const int n = A1.dimension();
  const bool wanted = has_effect(effects, ObjectEffects::depth) && warm != nullptr && n <= 3;
  const double* normal = wanted ? recorded_normal(*warm, n) : nullptr;
  has_start = normal != nullptr;
  if (has_start) std::copy_n(normal, n, start.begin());
}

void ObjectDistanceSolver::Workspace::add_depth(const Posed& A1, const Posed& A2, const ConvexSet& Q,
                                                ObjectEffects effects, WarmStart* warm) {
  if (!has_effect(effects, ObjectEffects::depth) || result.distance.lower > 0) {
    if (had_depth || result.depth.evaluations > 0) result.depth = ObjectDepth();
  } else if (result.depth.evaluations == 0) {
    find_depth(A1, A2, Q, warm);
  }
}

void ObjectDistanceSolver::Workspace::find_depth(const Posed& A1, const Posed& A2, const ConvexSet& Q,
                                                 WarmStart* warm) {
  depth.solve(A1, A2, Q, methods.options(), methods.stop(), has_start ? start.data() : nullptr,
              result.distance.seconds, result.depth);
  const int n = A1.dimension();
  if (warm == nullptr || n > 3 || result.depth.normal.size() != n) return;
  warm->dimension = n;
  std::copy_n(result.depth.normal.data(), n, warm->normal.begin());
}

// Where fixed-size code does not decide on a distance, a depth above 0 proves that there is none, and takes
// less time than the general methods.
bool ObjectDistanceSolver::Workspace::meet_in_depth(const Posed& A1, const Posed& A2, const ConvexSet& Q,
                                                    ObjectEffects effects, WarmStart* warm) {
  const int n = Q.dimension();
  if (!has_effect(effects, ObjectEffects::depth) || n > 3 || A1.dimension() != n || A2.dimension() != n)
    return false;
  result.distance.seconds = DistanceResult::kUnset;
  find_depth(A1, A2, Q, warm);
  if (!(result.depth.lower > 0)) return false;
  DistanceResult& distance = result.distance;
  distance.status = DistanceStatus::contains_origin;
  distance.distance = distance.lower = distance.upper = 0;
  distance.sigma = DistanceResult::kUnset;
  distance.counters = {};
  distance.origin_weights.clear();
  distance.normal.resize(0);
  distance.contact_point.resize(0);
  result.closest_point_evaluations = result.gradient_evaluations = 0;
  result.closest_point_1.resize(0);
  result.closest_point_2.resize(0);
  return true;
}

void ObjectDistanceSolver::Workspace::add_gradients(ObjectEffects effects) {
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
  workspace_->begin(posed_1, effects, warm);
  if (posed_1.dimension() == posed_2.dimension() &&
      workspace_->spatial.distance(posed_1, posed_2, Q, workspace_->methods.options(), effects, warm,
                                   workspace_->result)) {
    workspace_->add_depth(posed_1, posed_2, Q, effects, warm);
    workspace_->add_gradients(effects);
    return workspace_->result;
  }
  if (workspace_->meet_in_depth(posed_1, posed_2, Q, effects, warm)) {
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
  workspace.add_depth(posed_1, posed_2, Q, effects, warm);
  workspace.add_gradients(effects);
  return result;
}

}  // namespace raygauge
