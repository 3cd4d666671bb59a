// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/depth_query.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/bodies/general_oracle.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/queries/spatial_query.h"
#include "engine/sets/posed_view.h"
#include "engine/sets/spatial_shape.h"

namespace raygauge {
namespace {

constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;

void put(const Vector3& v, int n, double scale, Vector& out) {
  if (out.size() != n) out.resize(n);
  for (int k = 0; k < n; ++k) out[k] = (&v.x)[k] * scale;
}

}  // namespace

bool DepthQuery::solve_bodies(const Posed& A1, const Posed& A2, double radius, const DistanceOptions& options,
                              const DepthStart& start, ObjectDepth& result) {
  if (!bodies_.bind(A1.set, A2.set, options.instruction_set) ||
      !bodies_.place(PoseNumbers(A1.pose), PoseNumbers(A2.pose))) {
    return false;
  }
  bodies_.solve(options.tolerance, start, watch_, answer_);
  if (answer_.parted) return true;
  const int n = A1.dimension();
  result.lower = radius == 1 ? answer_.bounds.lower() : answer_.bounds.lower() / radius * kDown;
  result.upper = radius == 1 ? answer_.bounds.upper() : answer_.bounds.upper() / radius * kUp;
  result.status = answer_.status;
  result.iterations = answer_.iterations;
  result.support_queries = answer_.support_queries;
  put(answer_.normal, n, 1 / radius, result.normal);
  put(answer_.point_1, n, 1, result.point_1);
  put(answer_.point_2, n, 1, result.point_2);
  return true;
}

void DepthQuery::solve_sets(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
                            const double* start, ObjectDepth& result) {
  const int n = Q.dimension();
  GeneralOracle oracle(A1, A2, Q);
  Vector3 u{1, 0, 0};
  for (int k = 0; start != nullptr && k < n; ++k) (&u.x)[k] = start[k];
  if (!(dot(u, u) > 0)) u = {1, 0, 0};
  const DepthEnd end = search_.run(oracle, u, {tolerance, 0, 0, 0}, watch_);
  result.lower = std::max(0.0, search_.lower());
  result.upper = search_.upper();
  result.status = result.upper == 0 ? DistanceStatus::optimal : status_of(end);
  if (result.lower == kInfinity) result.status = DistanceStatus::unreachable;
  result.iterations = search_.iterations();
  result.support_queries = oracle.queries();
  Vector3 normal = search_.normal(), a1, a2;
  for (int k = n; k < 3; ++k) (&normal.x)[k] = 0;
  const double height = oracle.metric_upper(normal);
  put(normal, result.upper < kInfinity && height > 0 ? n : 0, 1 / height, result.normal);
  // The ray that leaves D across u first: depth q with h_Q(u) = u·q. Of a ball it is the one along u.
  Vector3 q = normal;
  Q.support_unchecked(&normal.x, &q.x);
  const bool known = search_.lower() > 0 && search_.contact(q, a1, a2);
  put(a1, known ? n : 0, 1, result.point_1);
  put(a2, known ? n : 0, 1, result.point_2);
}

void DepthQuery::solve_hull(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q, double tolerance,
                            const double* start, ObjectDepth& result) {
  const DepthEnd end = hull_.run(A1, A2, Q, tolerance, start, watch_);
  result.lower = hull_.lower();
  result.upper = hull_.upper();
  result.status = result.upper == 0 ? DistanceStatus::optimal : status_of(end);
  if (result.lower == kInfinity) result.status = DistanceStatus::unreachable;
  result.iterations = hull_.iterations();
  result.support_queries = hull_.queries();
  hull_.put_normal(result.normal);
  hull_.put_points(result.point_1, result.point_2);
}

// Directions ±e_k, with the rounding errors that ConvexSet states.
void DepthQuery::bound_along_axes(const ConvexSet& A1, const ConvexSet& A2, const ConvexSet& Q,
                                  ObjectDepth& result) {
  const int n = Q.dimension();
  Vector u = Vector::Zero(n), point(n), of_1(n), of_2(n), of_Q(n);
  A1.magnitude_unchecked(of_1.data());
  A2.magnitude_unchecked(of_2.data());
  Q.magnitude_unchecked(of_Q.data());
  const double unit = ConvexSet::rounding_error(n + 1);
  result.lower = 0;
  result.upper = kInfinity;
  result.status = DistanceStatus::precision_limit;
  for (int i = 0; i < 2 * n; ++i) {
    const int k = i / 2;
    u[k] = i % 2 == 0 ? 1.0 : -1.0;
    const double metric = Q.support_unchecked(u.data(), point.data()) - unit * of_Q[k];
    double height = A2.support_unchecked(u.data(), point.data());
    u[k] = -u[k];
    height += A1.support_unchecked(u.data(), point.data()) + unit * (of_1[k] + of_2[k]);
    const double upper = metric > 0 ? std::max(0.0, height / metric * kUp) : kInfinity;
    if (upper < result.upper) {
      result.upper = upper;
      result.normal = u * (-1 / metric);
    }
    u[k] = 0;
  }
  result.support_queries = std::int64_t{4} * n;
}

void DepthQuery::solve(const Posed& A1, const Posed& A2, const ConvexSet& Q, const DistanceOptions& options,
                       const std::function<bool()>& stop, const DepthStart& start, double seconds,
                       ObjectDepth& result) {
  watch_.start(std::isnan(seconds) ? options.time_limit : std::max(0.0, options.time_limit - seconds), &stop);
  const double radius = radius_of_ball(Q);
  result.iterations = result.support_queries = 0;
  by_bodies_ =
      is_open_to_bodies(options) && radius > 0 && solve_bodies(A1, A2, radius, options, start, result);
  if (!by_bodies_) {
    const InPose first(A1), second(A2);
    const int n = Q.dimension();
    const double* normal = start.pair != nullptr ? recorded_normal(*start.pair, n) : nullptr;
    if (n <= 3) {
      solve_sets(first.set(), second.set(), Q, options.tolerance, normal, result);
    } else if (n <= HullDepth::kMost) {
      solve_hull(first.set(), second.set(), Q, options.tolerance, normal, result);
    } else {
      bound_along_axes(first.set(), second.set(), Q, result);
    }
  }
  if (by_bodies_ && answer_.parted) {
    result = ObjectDepth();
    return;
  }
  result.depth = result.upper;
  result.evaluations = 1;
}

void DepthQuery::record(const ObjectDepth& depth, WarmStart& warm) {
  const auto n = static_cast<int>(depth.normal.size());
  if (n == 0 || n > 3) return;
  warm.dimension = n;
  warm.count = 0;
  std::copy_n(depth.normal.data(), n, warm.normal.begin());
  if (by_bodies_) bodies_.record(warm);
}

// What is as near as the bounds tell, and far enough from the normal not to be the same minimum of a curved
// surface.
void DepthQuery::other_normals(const ObjectDepth& depth, std::vector<Vector3>& normals) const {
  constexpr double kLeastGap = 1e-10, kCurved = 200;
  normals.clear();
  if (depth.evaluations == 0 || !(depth.lower > 0) || depth.normal.size() == 0) return;
  const double relative = std::max(kLeastGap, 2 * (depth.upper - depth.lower) / depth.upper);
  const double angle = std::min(1.0, std::sqrt(kCurved * relative));
  if (by_bodies_) return bodies_.add_near_normals(relative, angle, normals);
  search_.add_near_normals(relative, angle, normals);
}

}  // namespace raygauge
