// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/spatial_query.h"

#include <algorithm>
#include <limits>

#include "engine/sets/spatial_shape.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;
constexpr std::ptrdiff_t kPointsUnderLimit =
    10000;  // a hundred passes over so many end before the clock would be read

}  // namespace

bool SpatialQuery::bind(const Posed& first, const Posed& second, const DistanceOptions& options) {
  asked_ = false;
  if (!is_open_to_bodies(options) || !solve_.bind(first.set, second.set, options.instruction_set))
    return false;
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
  result.counters.support_queries = solve_.pair().queries();
  result.sigma = result.seconds = DistanceResult::kUnset;
  result.origin_weights.clear();
  if (result.contact_point.size() != 0) result.contact_point.resize(0);
}

bool SpatialQuery::distance(const Posed& A1, const Posed& A2, const ConvexSet& metric,
                            const DistanceOptions& options, ObjectEffects effects, WarmStart* warm,
                            ObjectDistance& result, bool* likely_overlap) {
  const double radius = radius_of_ball(metric);
  const bool measures = radius > 0 && metric.dimension() == A1.dimension();
  if (!measures || !bind(A1, A2, options) || !place(A1, A2)) {
    asked_ = false;
    proven_ = {};
    return false;
  }
  const bool found = solve_.distance(options.tolerance, warm, likely_overlap);
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

bool SpatialQuery::growth(const Posed& A, const Posed& Q, bool about_origin, const DistanceOptions& options,
                          double threshold, WarmStart* warm, DistanceResult& result, bool fine_normal) {
  if (!bind(Q, A, options) || !place(Q, A)) {
    proven_ = {};
    return false;
  }
  const bool found = solve_.growth(about_origin, options.tolerance, threshold, warm, fine_normal);
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
