// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "cli/commands/distance_query.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::cli {

/// The distance of two objects in a metric, as the program reports it.
struct BetweenReport {
  ObjectDistance answer;
  bool is_signed = false;  ///< objects that meet have minus their depth
  bool witness = false;    ///< whether points were asked for
  std::string method;
  double tolerance = 0, seconds = 0;
  int n = 0;
  ReportedSet A1, A2;

  /// Whether what is reported is minus a depth.
  bool is_depth() const noexcept { return answer.depth.evaluations > 0; }
  /// Of what is reported, the signed distance or the distance.
  double lower() const noexcept { return is_depth() ? -answer.depth.upper : answer.distance.lower; }
  double upper() const noexcept { return is_depth() ? -answer.depth.lower : answer.distance.upper; }
  DistanceStatus status() const noexcept { return is_depth() ? answer.depth.status : answer.distance.status; }
};

/// `metric` may be null: the Euclidean one. Throws UnknownNameError for a method that is not in `methods`,
/// InvalidParameterError for one that is not the engine's, DimensionMismatchError.
BetweenReport answer_between(const DistanceQuery& query, bool is_signed,
                             const std::shared_ptr<const ConvexSet>& A1,
                             const std::shared_ptr<const ConvexSet>& A2,
                             const std::shared_ptr<const ConvexSet>& metric, const MethodRegistry& methods);

/// The object that --json prints: distance (negative: minus the depth, with --signed), lower, upper, status,
/// meet (true, false or null where it is not decided), method, tolerance, seconds, n, n_points_A1,
/// n_points_A2, normal (the way for A1 to get farther away, or out), and with --witness point_1 and point_2.
Json between_json(const BetweenReport& report);

/// Several lines for people.
std::string between_text(const BetweenReport& report);

}  // namespace raygauge::cli
