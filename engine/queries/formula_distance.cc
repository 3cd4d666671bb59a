// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/formula_distance.h"

#include <cmath>

#include "engine/proof/bounds.h"
#include "engine/queries/pose_gradients.h"

namespace raygauge {
namespace {

// From lengths to those that the metric measures, rounded outward.
struct Scale {
  explicit Scale(double radius) {
    if (radius == 1) return;
    share = 1 / radius;
    down = share * (1 - 0x1p-50);
    up = share * (1 + 0x1p-50);
  }
  double share = 1, down = 1, up = 1;
};

void put(const Vector3& v, double scale, Vector& out) {
  if (out.size() != 3) out.resize(3);
  double* x = out.data();
  x[0] = v.x * scale;
  x[1] = v.y * scale;
  x[2] = v.z * scale;
}

void clear(Vector& v) {
  if (v.size() != 0) v.resize(0);
}

void put_distance(const RoundPair& round, const Scale& scale, bool points, ObjectDistance& result) {
  result.distance.status = DistanceStatus::optimal;
  result.distance.lower = round.lower() * scale.down;
  result.distance.upper = result.distance.distance = round.upper() * scale.up;
  put(round.normal(), scale.share, result.distance.normal);
  result.closest_point_evaluations = points ? 1 : 0;
  if (points) {
    put(round.point_1(), 1, result.closest_point_1);
    put(round.point_2(), 1, result.closest_point_2);
  } else {
    clear(result.closest_point_1);
    clear(result.closest_point_2);
  }
}

void put_overlap(ObjectDistance& result) {
  result.distance.status = DistanceStatus::contains_origin;
  result.distance.lower = result.distance.upper = result.distance.distance = 0;
  clear(result.distance.normal);
  result.closest_point_evaluations = 0;
  clear(result.closest_point_1);
  clear(result.closest_point_2);
}

void put_depth(const RoundPair& round, const Scale& scale, ObjectDepth& depth) {
  depth.lower = -round.upper() * scale.down;
  depth.depth = depth.upper = -round.lower() * scale.up;
  depth.status = DistanceStatus::optimal;
  put(round.normal(), scale.share, depth.normal);
  put(round.point_1(), 1, depth.point_1);
  put(round.point_2(), 1, depth.point_2);
  depth.evaluations = depth.iterations = 1;
  depth.support_queries = 2;
}

// The bounds count as everywhere: those of the distance, or of the depth.
bool is_known(const RoundPair& round, bool wanted, double tolerance) {
  const bool apart = round.lower() > 0, meet = round.upper() < 0;
  const double upper = apart ? round.upper() : -round.lower();
  return (apart || meet) && (!wanted || round.upper() - round.lower() <= tolerance * upper);
}

}  // namespace

bool distance_by_formula(RoundPair& round, const Posed& A1, const Posed& A2, const FormulaGoal& goal,
                         WarmStart* warm, ObjectDistance& result) {
  if (A1.set.spatial_shape() == nullptr || A2.set.spatial_shape() == nullptr) return false;
  const SpatialShape &one = *A1.set.spatial_shape(), &two = *A2.set.spatial_shape();
  if (A1.dimension() != 3 || A2.dimension() != 3 || !RoundPair::has_formula(one, two)) return false;
  const PoseNumbers pose_1(A1.pose), pose_2(A2.pose);
  if (!round.solve(one, two, pose_1, pose_2)) return false;
  const bool meet = round.upper() < 0, deep = meet && has_effect(goal.effects, ObjectEffects::depth);
  if (!is_known(round, deep || !meet, goal.tolerance)) return false;
  const bool by_pose = has_effect(goal.effects, ObjectEffects::pose_gradient) && (deep || !meet);
  if (by_pose && !round.is_differentiable(one, two, pose_1, pose_2)) return false;
  const Scale scale(goal.radius);
  if (meet)
    put_overlap(result);
  else
    put_distance(round, scale, has_effect(goal.effects, ObjectEffects::closest_points), result);
  if (deep)
    put_depth(round, scale, result.depth);
  else if (!std::isnan(result.depth.depth))
    result.depth = ObjectDepth();
  DistanceResult& distance = result.distance;
  distance.counters = {};
  distance.counters.outer_iterations = distance.counters.ray_iterations = 1;
  distance.counters.support_queries = deep ? 0 : 2;  // the depth counts them
  distance.sigma = distance.seconds = DistanceResult::kUnset;
  distance.origin_weights.clear();
  clear(distance.contact_point);
  result.gradient_evaluations = 0;
  result.pose_gradient_evaluations = by_pose ? 1 : 0;
  result.pose_gradient.kind = GradientKind::none;
  if (by_pose)
    put_single_gradient(A1, A2, round.normal() * scale.share, round.point_1(), round.point_2(),
                        result.pose_gradient);
  if (warm == nullptr) return true;
  warm->overlap = false;
  warm->dimension = 3;
  warm->count = 0;
  const Vector3 normal = meet && !deep ? Vector3{} : round.normal();
  warm->normal = {normal.x, normal.y, normal.z};
  return true;
}

}  // namespace raygauge
