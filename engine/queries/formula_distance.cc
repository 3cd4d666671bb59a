// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/formula_distance.h"

#include <cmath>

#include "engine/methods/spatial/round_pair.h"

namespace raygauge {
namespace {

using Formula = RoundPair::Formula;

[[gnu::noinline]] void resize(Vector& v, int n) { v.resize(n); }

[[gnu::always_inline]] inline void put(const Vector3& v, Vector& out) {
  if (out.size() != 3) resize(out, 3);
  double* x = out.data();
  x[0] = v.x;
  x[1] = v.y;
  x[2] = v.z;
}

[[gnu::always_inline]] inline void clear(Vector& v) {
  if (v.size() != 0) resize(v, 0);
}

[[gnu::noinline]] void clear(ObjectDepth& depth) { depth = ObjectDepth(); }

[[gnu::always_inline]] inline void put_distance(const RoundPair& round, bool points, ObjectDistance& result) {
  result.distance.status = DistanceStatus::optimal;
  result.distance.lower = round.lower;
  result.distance.upper = result.distance.distance = round.upper;
  put(round.normal, result.distance.normal);
  result.closest_point_evaluations = points ? 1 : 0;
  if (points) {
    put(round.point_1, result.closest_point_1);
    put(round.point_2, result.closest_point_2);
  } else {
    clear(result.closest_point_1);
    clear(result.closest_point_2);
  }
}

[[gnu::always_inline]] inline void put_overlap(ObjectDistance& result) {
  result.distance.status = DistanceStatus::contains_origin;
  result.distance.lower = result.distance.upper = result.distance.distance = 0;
  clear(result.distance.normal);
  result.closest_point_evaluations = 0;
  clear(result.closest_point_1);
  clear(result.closest_point_2);
}

[[gnu::always_inline]] inline void put_depth(const RoundPair& round, ObjectDepth& depth) {
  depth.lower = -round.upper;
  depth.depth = depth.upper = -round.lower;
  depth.status = DistanceStatus::optimal;
  put(round.normal, depth.normal);
  put(round.point_1, depth.point_1);
  put(round.point_2, depth.point_2);
  depth.evaluations = depth.iterations = 1;
  depth.support_queries = 2;
}

[[gnu::always_inline]] inline void put_counters(bool deep, ObjectDistance& result) {
  DistanceResult& distance = result.distance;
  distance.counters = {};
  distance.counters.outer_iterations = distance.counters.ray_iterations = 1;
  distance.counters.support_queries = deep ? 0 : 2;  // the depth counts them
  distance.sigma = distance.seconds = DistanceResult::kUnset;
  distance.origin_weights.clear();
  clear(distance.contact_point);
}

[[gnu::always_inline]] inline void put_gradient(const RoundPair& round, bool wanted, ObjectDistance& result) {
  result.gradient_evaluations = wanted ? 1 : 0;
  if (wanted) {
    put(round.normal, result.gradient_1);
    put(-round.normal, result.gradient_2);
  } else {
    clear(result.gradient_1);
    clear(result.gradient_2);
  }
}

Vector3 origin_of(const Posed& body) {
  if (body.pose == nullptr) return {};
  const double* t = body.pose->translation_data();
  return {t[0], t[1], t[2]};
}

// With one normal and one pair of points.
[[gnu::always_inline]] inline void put_pose_gradient(const RoundPair& round, const Posed& A1, const Posed& A2,
                                                     PoseGradient& gradient) {
  gradient.kind = GradientKind::unique;
  gradient.candidates.clear();
  gradient.body_1 = {round.normal, cross(round.point_1 - origin_of(A1), round.normal)};
  gradient.body_2 = {-round.normal, cross(round.normal, round.point_2 - origin_of(A2))};
}

// From lengths to those that a ball of this radius measures, rounded outward.
[[gnu::noinline]] void scale_to_radius(double radius, ObjectDistance& result) {
  const double share = 1 / radius, down = share * (1 - 0x1p-50), up = share * (1 + 0x1p-50);
  DistanceResult& distance = result.distance;
  ObjectDepth& depth = result.depth;
  distance.lower *= down;
  distance.upper = distance.distance *= up;
  depth.lower *= down;
  depth.upper = depth.depth *= up;
  for (Vector* v : {&distance.normal, &depth.normal, &result.gradient_1, &result.gradient_2}) *v *= share;
  PoseGradient& gradient = result.pose_gradient;
  if (gradient.kind == GradientKind::none) return;
  for (Twist* twist : {&gradient.body_1, &gradient.body_2})
    *twist = {twist->linear * share, twist->angular * share};
}

// The bounds count as everywhere: those of the distance, or of the depth.
bool is_close(const RoundPair& round, bool wanted, double tolerance) {
  const bool apart = round.lower > 0, meet = round.upper < 0;
  const double upper = apart ? round.upper : -round.lower;
  return (apart || meet) && (!wanted || round.upper - round.lower <= tolerance * upper);
}

// One function for each formula: what all begin with is little, and the compiler keeps it in registers.
template <Formula kFormula>
[[gnu::noinline]] bool answer_by(const Posed& A1, const Posed& A2, double radius, double tolerance,
                                 ObjectEffects effects, WarmStart* warm, ObjectDistance& result) {
  const SpatialShape &one = *A1.set.spatial_shape(), &two = *A2.set.spatial_shape();
  RoundPair round;
  round.solve<kFormula>(one, two, PoseNumbers(A1.pose), PoseNumbers(A2.pose));
  const bool meet = round.upper < 0, deep = meet && has_effect(effects, ObjectEffects::depth);
  if (!round.is_known || !is_close(round, deep || !meet, tolerance)) return false;
  const bool by_pose = has_effect(effects, ObjectEffects::pose_gradient) && (deep || !meet);
  if (by_pose && !RoundPair::is_differentiable(0.5 * (round.lower + round.upper), one, two,
                                               PoseNumbers(A1.pose), PoseNumbers(A2.pose)))
    return false;
  if (meet)
    put_overlap(result);
  else
    put_distance(round, has_effect(effects, ObjectEffects::closest_points), result);
  if (deep)
    put_depth(round, result.depth);
  else if (!std::isnan(result.depth.depth))
    clear(result.depth);
  put_counters(deep, result);
  put_gradient(round, has_effect(effects, ObjectEffects::gradient) && (deep || !meet), result);
  result.pose_gradient_evaluations = by_pose ? 1 : 0;
  result.pose_gradient.kind = GradientKind::none;
  if (by_pose) put_pose_gradient(round, A1, A2, result.pose_gradient);
  if (radius != 1) scale_to_radius(radius, result);
  if (warm == nullptr) return true;
  warm->overlap = false;
  warm->dimension = 3;
  warm->count = 0;
  const Vector3 normal = meet && !deep ? Vector3{} : round.normal;
  warm->normal = {normal.x, normal.y, normal.z};
  return true;
}

}  // namespace

bool distance_by_formula(const Posed& A1, const Posed& A2, const ConvexSet& metric, double tolerance,
                         ObjectEffects effects, WarmStart* warm, ObjectDistance& result) {
  const SpatialShape *one = A1.set.spatial_shape(), *two = A2.set.spatial_shape();
  if (one == nullptr || two == nullptr || A1.dimension() != 3 || A2.dimension() != 3) return false;
  const double radius = radius_of_ball(metric);
  if (!(radius > 0) || metric.dimension() != 3) return false;
  return RoundPair::with(RoundPair::formula(*one, *two), [&]<Formula kFormula>() {
    return answer_by<kFormula>(A1, A2, radius, tolerance, effects, warm, result);
  });
}

}  // namespace raygauge
