// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "raygauge/scene/edge_checker.h"

namespace raygauge {

/// A path to be found for the joints of a robot, each within its limits.
struct PlanRequest {
  RobotModel robot;
  std::vector<Body> obstacles;  ///< that stand still
  EdgeOptions options;
  std::vector<double> lower, upper;
  std::vector<double> start, goal;
  std::string planner = "rrt_connect";
  double time_limit = 10;  ///< seconds, for the search and for making the path shorter
  std::int64_t seed = 1;
  const std::atomic<bool>* stop = nullptr;  ///< true: the search ends as if its time were over
};

struct PlannedPath {
  DenseMatrix values;          ///< one row a joint, one column a configuration; no column: none was found
  double length = 0;           ///< Σ |change of the joints|, Euclidean
  double search_seconds = 0;   ///< until the first path
  double shorten_seconds = 0;  ///< for making it shorter and smoother
  double proof_seconds = 0;    ///< of one proof of the whole path, by a new checker
  std::int64_t motions = 0;    ///< edges that the planner asked about
  std::int64_t undecided = 0;  ///< verdicts that were undecided; they count as contacts

  bool found() const noexcept { return values.cols() > 0; }
};

/// The names that PlanRequest::planner may have.
const std::vector<std::string>& planner_names();

/// Whether this program has OMPL.
bool has_planners() noexcept;

/// A path whose every edge is proven to be free, shortened and smoothed. Throws UnknownNameError for a
/// planner, or InvalidParameterError for a time limit or seed out of range, or where OMPL is missing, or
/// start or goal is not within the limits or not proven free.
PlannedPath plan_path(const PlanRequest& request);

/// plan_path() after its checks.
PlannedPath plan_by_ompl(const PlanRequest& request);

}  // namespace raygauge
