// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/spatial_query.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/kernels/kernel.h"
#include "engine/methods/spatial/closed_form_distance.h"
#include "engine/methods/spatial/contact_distance.h"
#include "engine/methods/spatial/precise_distance.h"
#include "engine/methods/spatial/precise_growth.h"
#include "engine/methods/spatial/spatial_growth.h"

namespace raygauge {
namespace {

constexpr double kLeastSquare = 1e-200;  // of a normal that a start may have
constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;

// The radius of a ball about the origin; 0 for every other set.
double radius_of_metric(const ConvexSet& Q, SpatialShape& shape) {
  if (!Q.spatial_shape_unchecked(shape) || shape.kind != SpatialShape::Kind::point) return 0;
  return shape.center.x == 0 && shape.center.y == 0 && shape.center.z == 0 ? shape.radius : 0.0;
}

void set_counters(const SpatialPair& pair, const SpatialAnswer& answer, DistanceResult& result) {
  result.counters = {};
  result.counters.outer_iterations = 1;
  result.counters.ray_iterations = answer.iterations;
  result.counters.support_queries = pair.queries();
  result.sigma = result.seconds = DistanceResult::kUnset;
  result.origin_weights.clear();
  if (result.contact_point.size() != 0) result.contact_point.resize(0);
}

}  // namespace

bool SpatialQuery::bind(const Posed& first, const Posed& second, const DistanceOptions& options) {
  const bool open = options.method != DistanceMethod::zheng_yamane && options.max_iterations == 0 &&
                    options.time_limit == std::numeric_limits<double>::infinity();
  return open && pair_.bind(first, second, options.instruction_set);
}

void SpatialQuery::begin(const WarmStart* warm) {
  start_.has_normal = false;
  start_.count = 0;
  if (warm == nullptr || warm->dimension != pair_.dimension()) return;
  if (const double* normal = recorded_normal(*warm, pair_.dimension())) {
    start_.has_normal = true;
    start_.normal = -pair_.to_body(normal);
    const double square = dot(start_.normal, start_.normal);
    start_.has_normal = square > kLeastSquare && square < 1 / kLeastSquare;
  }
  if (!pair_.has_vertices()) return;
  start_.count = std::clamp(warm->count, 0, 4);
  std::copy_n(warm->point_A.begin(), start_.count, start_.index_1);
  std::copy_n(warm->point_Q.begin(), start_.count, start_.index_2);
}

void SpatialQuery::record(const SpatialAnswer& answer, const Vector& normal, WarmStart* warm) const {
  if (warm == nullptr) return;
  record_normal(normal, *warm);
  warm->dimension = pair_.dimension();
  if (normal.size() == 0) warm->normal = {0, 0, 0};
  if (!pair_.has_vertices()) return;
  warm->count = answer.combination.count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(warm->count); ++i) {
    warm->point_A[i] = answer.combination.point[i].index_1;
    warm->point_Q[i] = answer.combination.point[i].index_2;
  }
}

void SpatialQuery::closest_points(const SpatialAnswer& answer, ObjectDistance& result) const {
  const SpatialCombination& combination = answer.combination;
  Vector3 a1, a2;
  for (int i = 0; i < combination.count; ++i) {
    a1 = a1 + combination.point[i].a1 * combination.weight[i];
    a2 = a2 + combination.point[i].a2 * combination.weight[i];
  }
  const Vector3 way = a2 - a1;
  const double size = pair_.radius() > 0 ? length(way) : 0.0;
  if (size > 0) {
    a1 = a1 + way * (pair_.shape(0).radius / size);
    a2 = a2 - way * (pair_.shape(1).radius / size);
  }
  result.closest_point_1.resize(pair_.dimension());
  result.closest_point_2.resize(pair_.dimension());
  pair_.point_to_world(a1, result.closest_point_1.data());
  pair_.point_to_world(a2, result.closest_point_2.data());
  ++result.closest_point_evaluations;
}

// Balls and capsules have formulas. Curved bodies that are near are left to Newton steps; the long way is for
// what these do not close.
bool SpatialQuery::find_distance(const Posed& A1, const Posed& A2, const DistanceOptions& options) {
  if (closed_form_distance(pair_, options.tolerance, answer_)) return true;
  const bool newton = pair_.is_curved() && pair_.dimension() == 3;
  const Kernels& kernels = kernels_for(options.instruction_set);
  for (const bool leave_near : {true, false}) {
    spatial_distance(pair_, options.tolerance, start_, newton && leave_near, answer_);
    if (answer_.end == SpatialEnd::open && newton) contact_distance(pair_, options.tolerance, answer_);
    if (answer_.end == SpatialEnd::open) precise_distance(pair_, A1, A2, kernels, options.tolerance, answer_);
    if (answer_.end == SpatialEnd::closed || answer_.end == SpatialEnd::intersecting) return true;
    if (!newton) break;
  }
  return false;
}

bool SpatialQuery::distance(const Posed& A1, const Posed& A2, const ConvexSet& metric,
                            const DistanceOptions& options, ObjectEffects effects, WarmStart* warm,
                            ObjectDistance& result) {
  const double radius = radius_of_metric(metric, metric_);
  if (!(radius > 0) || metric.dimension() != A1.dimension() || !bind(A1, A2, options)) return false;
  begin(warm);
  const SpatialAnswer& answer = answer_;
  if (!find_distance(A1, A2, options)) return false;
  DistanceResult& distance = result.distance;
  result.closest_point_evaluations = result.gradient_evaluations = 0;
  const bool apart = answer.end == SpatialEnd::closed;
  if (apart) {
    const double share = radius == 1 ? 1.0 : 1 / radius;
    distance.status = DistanceStatus::optimal;
    distance.lower = radius == 1 ? answer.lower : answer.lower * share * kDown;
    distance.upper = radius == 1 ? answer.upper : answer.upper * share * kUp;
    distance.distance = distance.upper;
    distance.normal.resize(pair_.dimension());
    pair_.to_world(answer.normal * (-share / length(answer.normal)), distance.normal.data());
  } else {
    distance.status = DistanceStatus::contains_origin;
    distance.distance = distance.lower = distance.upper = 0;
    distance.normal.resize(0);
  }
  set_counters(pair_, answer, distance);
  if (apart && has_effect(effects, ObjectEffects::closest_points)) {
    closest_points(answer, result);
  } else {
    result.closest_point_1.resize(0);
    result.closest_point_2.resize(0);
  }
  record(answer, distance.normal, warm);
  return true;
}

// The bodies share their centre.
bool SpatialQuery::no_growth(WarmStart* warm, DistanceResult& result) {
  answer_.reset();
  result.status = DistanceStatus::contains_origin;
  result.distance = result.lower = result.upper = 0;
  result.normal.resize(0);
  set_counters(pair_, answer_, result);
  record(answer_, result.normal, warm);
  return true;
}

bool SpatialQuery::growth(const Posed& A, const Posed& Q, bool about_origin, const DistanceOptions& options,
                          double threshold, WarmStart* warm, DistanceResult& result) {
  if (!bind(Q, A, options)) return false;
  if (about_origin && !pair_.scale_first_about_origin(Q)) return false;
  if (!about_origin && pair_.is_concentric()) return no_growth(warm, result);
  begin(warm);
  const SpatialAnswer& answer = answer_;
  spatial_growth(pair_, options.tolerance, threshold, start_, answer_);
  if (answer.end == SpatialEnd::open && !about_origin) {
    precise_growth(pair_, Q, A, kernels_for(options.instruction_set), options.tolerance, answer_);
  }
  if (answer.end == SpatialEnd::open) return false;
  result.status = DistanceStatus::optimal;
  result.lower = answer.lower;
  result.upper = answer.upper;
  result.distance = std::min(answer.upper, std::numeric_limits<double>::max());
  if (answer.lower > 0) {
    result.normal.resize(pair_.dimension());
    const double along = dot(answer.normal, pair_.between_centers());
    pair_.to_world(answer.normal * (-answer.lower / along), result.normal.data());
  } else {
    result.normal.resize(0);
  }
  set_counters(pair_, answer, result);
  record(answer, result.normal, warm);
  return true;
}

}  // namespace raygauge
