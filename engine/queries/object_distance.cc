// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/object_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/queries/depth_query.h"
#include "engine/queries/growth_solve.h"
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
  GrowthSolve growth;
  DistanceResult factor;  // of growth

  bool solve_spatial(const Posed& A1, const Posed& A2, const ConvexSet& Q, ObjectEffects effects,
                     WarmStart* warm, ProvenBounds& proven);
  void solve_by_methods(const Posed& A1, const Posed& A2, const ConvexSet& Q, bool closest_points,
                        const ProvenBounds& proven, WarmStart* warm);
  void try_overlap(const Posed& A1, const Posed& A2);
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
  set_overlap(distance);
  distance.sigma = DistanceResult::kUnset;
  distance.counters = {};
  distance.origin_weights.clear();
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

bool ObjectDistanceSolver::Workspace::solve_spatial(const Posed& A1, const Posed& A2, const ConvexSet& Q,
                                                    ObjectEffects effects, WarmStart* warm,
                                                    ProvenBounds& proven) {
  if (A1.dimension() != A2.dimension()) return false;
  if (spatial.distance(A1, A2, Q, methods.options(), effects, warm, result)) return true;
  proven = spatial.proven();
  return false;
}

// From what fixed-size code has proven.
void ObjectDistanceSolver::Workspace::solve_by_methods(const Posed& posed_1, const Posed& posed_2,
                                                       const ConvexSet& Q, bool closest_points,
                                                       const ProvenBounds& proven, WarmStart* warm) {
  const InPose in_pose_1(posed_1), in_pose_2(posed_2);
  const ConvexSet& A1 = in_pose_1.set();
  const ConvexSet& A2 = in_pose_2.set();
  const int n = A2.dimension();
  const ObjectPair pair(A2, A1, closest_points);
  check_dimension("distance", "Q", Q.dimension(), n);
  if (closest_points) pairs.begin(pair);
  Aim aim;
  aim.pairs = closest_points ? &pairs : nullptr;
  result.distance = methods.solve(Posed(pair), Posed(Q), Effects::none, warm, aim);
  result.closest_point_evaluations = result.gradient_evaluations = 0;
  const bool apart = result.distance.lower > 0 && std::isfinite(result.distance.upper);
  if (closest_points && apart && methods.nearest_points(result.closest_point_1, result.closest_point_2)) {
    ++result.closest_point_evaluations;
  } else if (closest_points && apart && methods.contact_combination(combination)) {
    find_closest_points(n);
  } else {
    result.closest_point_1.resize(0);
    result.closest_point_2.resize(0);
  }
  tighten(proven, n, methods.options().tolerance, result.distance);
}

// Objects that meet when each is scaled by less than 1 share a point, whatever the metric.
void ObjectDistanceSolver::Workspace::try_overlap(const Posed& A1, const Posed& A2) {
  const DistanceOptions& options = methods.options();
  DistanceResult& distance = result.distance;
  const bool open = !(distance.lower > 0) && distance.status == DistanceStatus::precision_limit;
  if (!open || options.max_iterations != 0) return;
  if (!spatial.growth(A2, A1, false, options, 1.0, nullptr, factor)) {
    Aim aim;
    aim.threshold = 1;
    if (options.time_limit < std::numeric_limits<double>::infinity())
      aim.time_limit = options.time_limit - distance.seconds;
    factor = growth.solve(A2, A1, false, aim, nullptr, methods);
  }
  if (factor.upper < 1) set_overlap(distance);
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
  Workspace& workspace = *workspace_;
  workspace.begin(posed_1, effects, warm);
  ProvenBounds proven;
  if (!workspace.solve_spatial(posed_1, posed_2, Q, effects, warm, proven) &&
      !workspace.meet_in_depth(posed_1, posed_2, Q, effects, warm)) {
    workspace.solve_by_methods(posed_1, posed_2, Q, has_effect(effects, ObjectEffects::closest_points),
                               proven, warm);
    workspace.try_overlap(posed_1, posed_2);
  }
  workspace.add_depth(posed_1, posed_2, Q, effects, warm);
  workspace.add_gradients(effects);
  return workspace.result;
}

}  // namespace raygauge
