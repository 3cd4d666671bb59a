// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/spatial_query.h"

#include <algorithm>
#include <limits>

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
constexpr std::ptrdiff_t kPointsUnderLimit =
    10000;  // a hundred passes over so many end before the clock would be read

// The radius of a ball about the origin; 0 for every other set.
double radius_of_metric(const ConvexSet& Q, SpatialShape& shape) {
  if (!Q.spatial_shape_unchecked(shape) || shape.kind != SpatialShape::Kind::point) return 0;
  return shape.center.x == 0 && shape.center.y == 0 && shape.center.z == 0 ? shape.radius : 0.0;
}

void put(const Vector3& v, int n, double scale, Vector& out) {
  out.resize(n);
  for (int k = 0; k < n; ++k) out[k] = (&v.x)[k] * scale;
}

}  // namespace

bool SpatialQuery::bind(const Posed& first, const Posed& second, const DistanceOptions& options) {
  asked_ = false;
  const bool open = options.method != DistanceMethod::zheng_yamane && options.max_iterations == 0;
  if (!open || !solve_.bind(first.set, second.set, options.instruction_set)) return false;
  const bool limited = options.time_limit != std::numeric_limits<double>::infinity();
  return !limited || solve_.points() <= kPointsUnderLimit;
}

bool SpatialQuery::place(const Posed& first, const Posed& second) {
  return asked_ = solve_.place(PoseNumbers(first.pose), PoseNumbers(second.pose));
}

void SpatialQuery::set_counters(DistanceResult& result) const {
  result.counters = {};
  result.counters.outer_iterations = 1;
  result.counters.ray_iterations = solve_.answer().iterations;
  result.counters.support_queries = solve_.support_queries();
  clear_rest(result);
}

// What these queries do not find.
void SpatialQuery::clear_rest(DistanceResult& result) {
  result.sigma = result.seconds = DistanceResult::kUnset;
  result.origin_weights.clear();
  if (result.contact_point.size() != 0) result.contact_point.resize(0);
}

bool SpatialQuery::distance(const Posed& A1, const Posed& A2, const ConvexSet& metric,
                            const DistanceOptions& options, ObjectEffects effects, WarmStart* warm,
                            ObjectDistance& result) {
  const double radius = radius_ = radius_of_metric(metric, metric_);
  const bool bound = radius > 0 && metric.dimension() == A1.dimension() && bind(A1, A2, options);
  if (bound && distance_by_formula(A1, A2, options, effects, warm, result)) return true;
  if (!bound || !place(A1, A2)) {
    asked_ = false;
    proven_ = {};
    return false;
  }
  const bool found = solve_.distance(options.tolerance, warm);
  const SpatialAnswer& answer = solve_.answer();
  const int n = solve_.dimension();
  DistanceResult& distance = result.distance;
  const bool apart = answer.end != SpatialEnd::intersecting;
  const double share = radius == 1 ? 1.0 : 1 / radius;
  const double lower = !apart        ? 0
                       : radius == 1 ? answer.bounds.lower()
                                     : answer.bounds.lower() * share * kDown;
  const double upper = !apart ? 0 : radius == 1 ? answer.bounds.upper() : answer.bounds.upper() * share * kUp;
  if (!found) {
    proven_ = {{lower, upper}};
    for (int k = 0; lower > 0 && k < n; ++k) proven_.normal[k] = solve_.normal()[k] * share;
    return false;
  }
  result.closest_point_evaluations = result.gradient_evaluations = 0;
  distance.status = apart ? DistanceStatus::optimal : DistanceStatus::contains_origin;
  distance.lower = lower;
  distance.upper = upper;
  distance.distance = upper;
  distance.normal.resize(apart ? n : 0);
  for (int k = 0; apart && k < n; ++k) distance.normal[k] = solve_.normal()[k] * share;
  set_counters(distance);
  const bool points = apart && has_effect(effects, ObjectEffects::closest_points);
  result.closest_point_1.resize(points ? n : 0);
  result.closest_point_2.resize(points ? n : 0);
  if (!points) return true;
  solve_.closest_points(result.closest_point_1.data(), result.closest_point_2.data());
  ++result.closest_point_evaluations;
  return true;
}

// In one go, for what takes less time than a pair to be placed.
bool SpatialQuery::distance_by_formula(const Posed& A1, const Posed& A2, const DistanceOptions& options,
                                       ObjectEffects effects, WarmStart* warm, ObjectDistance& result) {
  const SpatialShape &one = solve_.pair().shape(0), &two = solve_.pair().shape(1);
  // The gradient of the distance from a ball needs no faces; others do, where the bodies are.
  const bool by_pose = has_effect(effects, ObjectEffects::pose_gradient);
  if (solve_.dimension() != 3 || !RoundPair::has_formula(one, two) ||
      (by_pose && !is_point(one) && !is_point(two)) ||
      !round_.solve(one, two, PoseNumbers(A1.pose), PoseNumbers(A2.pose))) {
    return false;
  }
  const bool meet = round_.upper() < 0, deep = meet && has_effect(effects, ObjectEffects::depth);
  const Bounds bounds(round_.lower(), round_.upper());
  if (!meet && !(round_.lower() > 0 && bounds.close(options.tolerance))) return false;
  if (meet && by_pose) return false;
  if (deep && !depth_by_formula(options, result.depth)) return false;
  DistanceResult& distance = result.distance;
  const double share = radius_ == 1 ? 1.0 : 1 / radius_;
  const bool scaled = !meet && radius_ != 1;
  distance.status = meet ? DistanceStatus::contains_origin : DistanceStatus::optimal;
  distance.lower = meet ? 0 : scaled ? bounds.lower() * share * kDown : bounds.lower();
  distance.upper = distance.distance = meet ? 0 : scaled ? bounds.upper() * share * kUp : bounds.upper();
  put(round_.normal(), meet ? 0 : 3, share, distance.normal);
  distance.counters = {};
  distance.counters.outer_iterations = distance.counters.ray_iterations = 1;
  distance.counters.support_queries = deep ? 0 : 2;  // the depth counts them
  clear_rest(distance);
  const bool points = !meet && has_effect(effects, ObjectEffects::closest_points);
  put(round_.point_1(), points ? 3 : 0, 1, result.closest_point_1);
  put(round_.point_2(), points ? 3 : 0, 1, result.closest_point_2);
  result.closest_point_evaluations = points ? 1 : 0;
  result.gradient_evaluations = 0;
  by_formula_ = true;
  if (warm == nullptr) return true;
  warm->dimension = 3;
  warm->count = 0;
  const Vector3 normal = meet && !deep ? Vector3{} : round_.normal();
  warm->normal = {normal.x, normal.y, normal.z};
  return true;
}

bool SpatialQuery::depth_by_formula(const DistanceOptions& options, ObjectDepth& depth) {
  const Bounds bounds(-round_.upper(), -round_.lower());
  if (!bounds.close(options.tolerance)) return false;
  const double share = radius_ == 1 ? 1.0 : 1 / radius_;
  depth.lower = radius_ == 1 ? bounds.lower() : bounds.lower() * share * kDown;
  depth.depth = depth.upper = radius_ == 1 ? bounds.upper() : bounds.upper() * share * kUp;
  depth.status = DistanceStatus::optimal;
  put(round_.normal(), 3, share, depth.normal);
  put(round_.point_1(), 3, 1, depth.point_1);
  put(round_.point_2(), 3, 1, depth.point_2);
  depth.evaluations = depth.iterations = 1;
  depth.support_queries = 2;
  return true;
}

bool SpatialQuery::growth(const Posed& A, const Posed& Q, bool about_origin, const DistanceOptions& options,
                          double threshold, WarmStart* warm, DistanceResult& result) {
  if (!bind(Q, A, options) || !place(Q, A)) {
    proven_ = {};
    return false;
  }
  const bool found = solve_.growth(about_origin, options.tolerance, threshold, warm);
  const SpatialAnswer& answer = solve_.answer();
  if (!found) {
    proven_ = {answer.bounds};
    if (answer.bounds.lower() > 0) solve_.growth_normal(proven_.normal);
    return false;
  }
  result.status = answer.bounds.upper() > 0 ? DistanceStatus::optimal : DistanceStatus::contains_origin;
  result.lower = answer.bounds.lower();
  result.upper = answer.bounds.upper();
  result.distance = std::min(answer.bounds.upper(), std::numeric_limits<double>::max());
  result.normal.resize(answer.bounds.lower() > 0 ? solve_.dimension() : 0);
  if (answer.bounds.lower() > 0) solve_.growth_normal(result.normal.data());
  set_counters(result);
  return true;
}

Separation SpatialQuery::separation(const Posed& A1, const Posed& A2, const DistanceOptions& options) {
  constexpr double kAny = 1 - 0x1p-20;  // a gap that any positive lower bound closes
  if (!bind(A1, A2, options) || !place(A1, A2)) return Separation::undecided;
  solve_.distance(kAny, nullptr);
  const SpatialAnswer& answer = solve_.answer();
  if (answer.end == SpatialEnd::intersecting) return Separation::intersecting;
  return answer.bounds.lower() > 0 ? Separation::separated : Separation::undecided;
}

Vector SpatialQuery::normal() const { return Vector::Map(solve_.normal(), solve_.dimension()); }

}  // namespace raygauge
