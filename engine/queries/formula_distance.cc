// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/formula_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "engine/methods/spatial/round_pair.h"
#include "engine/numerics/fused.h"
#include "engine/queries/ladder.h"

namespace raygauge {
namespace {

using Formula = RoundPair::Formula;

[[gnu::noinline, gnu::cold]] void resize(Vector& v, int n) { v.resize(n); }

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

[[gnu::noinline, gnu::cold]] void clear(ObjectDepth& depth) { depth = ObjectDepth(); }

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
  distance.counters = {.outer_iterations = 1, .ray_iterations = 1};
  if (!deep) distance.counters.support_queries = 2;  // the depth counts them
  distance.sigma = distance.seconds = DistanceResult::kUnset;
  distance.origin_weights.clear();
  clear(distance.contact_point);
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

// The gradients that are wanted of a value that is known.
[[gnu::always_inline]] inline void put_gradients(const RoundPair& round, const Posed& A1, const Posed& A2,
                                                 ObjectEffects effects, ObjectDistance& result) {
  const bool wanted = has_effect(effects, ObjectEffects::gradient);
  const bool by_pose = has_effect(effects, ObjectEffects::pose_gradient);
  result.gradient_evaluations = wanted ? 1 : 0;
  if (wanted) {
    put(round.normal, result.gradient_1);
    put(-round.normal, result.gradient_2);
  } else {
    clear(result.gradient_1);
    clear(result.gradient_2);
  }
  result.pose_gradient_evaluations = by_pose ? 1 : 0;
  result.pose_gradient.kind = GradientKind::none;
  if (by_pose) put_pose_gradient(round, A1, A2, result.pose_gradient);
}

// From lengths to those that a ball of this radius measures, rounded outward.
[[gnu::noinline, gnu::cold]] void scale_to_radius(double radius, ObjectDistance& result) {
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

void remember(const Vector3& normal, WarmStart& warm) {
  warm.overlap = false;
  warm.dimension = 3;
  warm.count = 0;
  warm.normal = {normal.x, normal.y, normal.z};
}

// Numbers of a pose, and those of the identity where there is none.
[[gnu::always_inline]] inline PoseNumbers numbers_of(const Pose* pose) {
  static constexpr double kNowhere[] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  if (pose == nullptr) return {kNowhere, kNowhere + 9, 0};
  if (pose->dimension() > 3) __builtin_unreachable();  // is_spatial()
  return {pose->rotation_data(), pose->translation_data(), pose->defect()};
}

using Answer = const ObjectDistance& (*)(Ladder&, const Posed&, const Posed&, const ConvexSet&, ObjectEffects,
                                         WarmStart*);

[[gnu::noinline]] bool is_differentiable(double value, const Posed& A1, const Posed& A2) {
  return RoundPair::is_differentiable(value, *A1.set.spatial_shape(), *A2.set.spatial_shape(),
                                      numbers_of(A1.pose), numbers_of(A2.pose));
}

// Whether there is a value, of the distance or the depth, or none is asked for.
[[gnu::always_inline]] inline bool is_valued(const RoundPair& round, ObjectEffects effects) {
  return round.lower > 0 || (round.upper < 0 && has_effect(effects, ObjectEffects::depth));
}

// The bounds count as everywhere: those of the distance, or of the depth.
[[gnu::always_inline]] inline bool is_close(const RoundPair& round, ObjectEffects effects,
                                            const Ladder& ladder) {
  const bool apart = round.lower > 0;
  if (!round.is_known || !(apart || round.upper < 0)) return false;
  const double upper = apart ? round.upper : -round.lower;
  return !is_valued(round, effects) ||
         round.upper - round.lower <= std::max(ladder.options().tolerance * upper, ladder.enough());
}

[[gnu::always_inline]] inline void put_answer(const RoundPair& round, const Posed& A1, const Posed& A2,
                                              ObjectEffects effects, ObjectDistance& result) {
  const bool meet = round.upper < 0, valued = is_valued(round, effects), deep = meet && valued;
  if (meet)
    put_overlap(result);
  else
    put_distance(round, has_effect(effects, ObjectEffects::closest_points), result);
  if (deep)
    put_depth(round, result.depth);
  else if (!std::isnan(result.depth.depth))
    clear(result.depth);
  put_counters(deep, result);
  put_gradients(round, A1, A2, valued ? effects : ObjectEffects::none, result);
}

// One function for each formula: what all begin with is little, and the compiler keeps it in registers.
template <Formula kFormula>
RAYGAUGE_VECTORS [[gnu::noinline]] const ObjectDistance& answer_by(Ladder& ladder, const Posed& A1,
                                                                   const Posed& A2, const ConvexSet& metric,
                                                                   ObjectEffects effects, WarmStart* warm) {
  const SpatialShape &one = *A1.set.spatial_shape(), &two = *A2.set.spatial_shape();
  RoundPair round;
  round.solve<kFormula>(one, two, numbers_of(A1.pose), numbers_of(A2.pose));
  if (!is_close(round, effects, ladder)) return distance_by_search(ladder, A1, A2, metric, effects, warm);
  const bool valued = is_valued(round, effects);
  const double value = 0.5 * (round.lower + round.upper);
  if (valued && has_effect(effects, ObjectEffects::pose_gradient) &&
      !RoundPair::has_one_way<kFormula>(value, one, two, numbers_of(A1.pose), numbers_of(A2.pose)) &&
      (kFormula == Formula::segments || !is_differentiable(value, A1, A2)))
    return distance_by_search(ladder, A1, A2, metric, effects, warm);
  ObjectDistance& result = ladder.answer();
  put_answer(round, A1, A2, effects, result);
  const double radius = metric.spatial_shape()->radius;
  if (radius != 1) scale_to_radius(radius, result);
  if (warm != nullptr) remember(valued ? round.normal : Vector3{}, *warm);
  return result;
}

template <Formula kFormula>
constexpr Answer answer_of() {
  if constexpr (kFormula == Formula::none)
    return distance_by_search;
  else
    return answer_by<kFormula>;
}

template <std::size_t... kFormulas>
constexpr std::array<Answer, sizeof...(kFormulas)> answers(std::index_sequence<kFormulas...> /*all*/) {
  return {answer_of<static_cast<Formula>(kFormulas)>()...};
}

bool is_spatial(const Posed& body) {
  return body.set.spatial_shape() != nullptr && body.dimension() == 3 &&
         (body.pose == nullptr || body.pose->dimension() == 3);
}

}  // namespace

const ObjectDistance& distance_by_formula(Ladder& ladder, const Posed& A1, const Posed& A2,
                                          const ConvexSet& metric, ObjectEffects effects, WarmStart* warm) {
  static constexpr auto kAnswers = answers(std::make_index_sequence<RoundPair::kFormulas>());
  if (!is_spatial(A1) || !is_spatial(A2) || metric.dimension() != 3 || !(radius_of_ball(metric) > 0))
    return distance_by_search(ladder, A1, A2, metric, effects, warm);
  const Formula formula = RoundPair::formula(*A1.set.spatial_shape(), *A2.set.spatial_shape());
  return kAnswers[static_cast<std::size_t>(formula)](ladder, A1, A2, metric, effects, warm);
}

}  // namespace raygauge
