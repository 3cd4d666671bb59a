// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/distance_query.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include "engine/queries/streamed_hull.h"
#include "engine/sweep/limited_load.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::cli {
namespace {

std::optional<DistanceMethod> engine_method(const std::string& name) {
  constexpr std::array<DistanceMethod, 3> kMethods = {DistanceMethod::column_generation,
                                                      DistanceMethod::zheng_yamane, DistanceMethod::newton};
  for (const DistanceMethod method : kMethods) {
    if (to_string(method) == name) return method;
  }
  return std::nullopt;
}

template <class Solve>
double seconds_of(const Solve& solve) {
  const auto start = std::chrono::steady_clock::now();
  solve();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void solve_by_engine(const DistanceQuery& query, DistanceMethod method, const Instance& instance,
                     DistanceReport& report) {
  DistanceOptions options = query.options;
  options.method = method;
  DistanceSolver solver(options);
  const Effects effects = query.witness ? Effects::witness : Effects::none;
  report.seconds = seconds_of([&] { report.result = solver.solve(*instance.A, *instance.Q, effects); });
}

void solve_by_baseline(const DistanceQuery& query, SolveMethod& method, const Instance& instance,
                       DistanceReport& report) {
  const std::string name = "method '" + report.method + "'";
  if (query.witness) {
    throw InvalidParameterError(
        name + " computes no contact point: --witness needs column_generation, zheng_yamane or newton");
  }
  if (query.engine_options_set) {
    throw InvalidParameterError(
        "--max-iterations, --stop-rule, --instruction-set and --threads are for column_generation, "
        "zheng_yamane and newton; " +
        name + " has no such options");
  }
  const SolveRequest request{query.options.tolerance, query.options.time_limit};
  limit_load(method, request.time_limit);
  const double loading = seconds_of([&] { method.load(instance); });
  report.seconds = loading + seconds_of([&] { method.solve(request); });
  report.result = method.result();
}

// Seconds that the check of Q may take: as many as the solve, or so few that nobody waits for them.
constexpr double kCheckAtLeast = 0.01;

double seconds_for_check(double time_limit, double seconds_of_solve) {
  return std::max(0.0, std::min(time_limit - seconds_of_solve, std::max(seconds_of_solve, kCheckAtLeast)));
}

// An unreachable A has settled it: its Farkas direction has all of Q on one side. Of other sets than point
// sets only a ball around the origin that they know of proves anything.
OriginInInterior precondition_of(const ConvexSet& Q, const DistanceResult& result, double seconds) {
  using Answer = OriginInInterior::Answer;
  if (result.status == DistanceStatus::unreachable) return {Answer::violated, result.normal};
  if (const PointSet* points = as_point_set(Q)) return origin_in_interior(*points, seconds);
  if (const StreamedHull* hull = as_streamed_hull(Q)) {
    const OriginInInterior some = origin_in_interior(hull->beginning(), seconds);
    return some.answer == Answer::holds ? some : OriginInInterior{Answer::unknown, {}};
  }
  const Vector origin = Vector::Zero(Q.dimension());
  return {Q.inner_radius_unchecked(origin.data()) > 0 ? Answer::holds : Answer::unknown, {}};
}

ReportedSet reported(const ConvexSet& set) {
  if (const StreamedHull* hull = as_streamed_hull(set)) return {set.structure(), hull->size()};
  const PointSet* points = as_point_set(set);
  return {set.structure(), points == nullptr ? 0 : points->size()};
}

}  // namespace

DistanceReport answer(const DistanceQuery& query, const Instance& instance, const MethodRegistry& methods) {
  DistanceReport report;
  report.method = query.method == to_string(DistanceMethod::automatic)
                      ? std::string(to_string(method_for(*instance.Q)))
                      : methods.find(query.method).name;
  report.tolerance = query.options.tolerance;
  report.n = instance.A->dimension();
  report.A = reported(*instance.A);
  report.Q = reported(*instance.Q);
  report.witness = query.witness;
  if (const auto method = engine_method(report.method)) {
    solve_by_engine(query, *method, instance, report);
  } else {
    solve_by_baseline(query, *methods.make(report.method, {}), instance, report);
  }
  const double seconds = seconds_for_check(query.options.time_limit, report.seconds);
  report.check_seconds =
      seconds_of([&] { report.precondition = precondition_of(*instance.Q, report.result, seconds); });
  return report;
}

bool may_stream(const DistanceQuery& query) {
  return query.method == to_string(DistanceMethod::automatic) || engine_method(query.method).has_value();
}

}  // namespace raygauge::cli
