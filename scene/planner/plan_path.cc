// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/planner/plan_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

void check_end(EdgeChecker& checker, const PlanRequest& request, const std::vector<double>& q,
               const char* end) {
  if (q.size() != request.lower.size() || q.size() != request.upper.size()) {
    throw DimensionMismatchError(std::string("the ") + end + " of a plan needs a value for each joint");
  }
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (q[i] >= request.lower[i] && q[i] <= request.upper[i]) continue;
    throw InvalidParameterError(std::string("the ") + end + " is beyond the limits of joint number " +
                                std::to_string(i + 1));
  }
  const EdgeResult& result = checker.configuration(q);
  if (result.outcome == EdgeOutcome::free) return;
  std::ostringstream text;
  text << "the " << end << " of the plan is "
       << (result.outcome == EdgeOutcome::contact ? "in contact" : "undecided") << ": '"
       << checker.name(result.body_a) << "' and '" << checker.name(result.body_b) << "'";
  if (result.outcome == EdgeOutcome::contact && result.upper > request.options.contact)
    text << " are " << result.upper << " apart at most, the margin is " << request.options.margin;
  throw InvalidParameterError(text.str());
}

void check_numbers(const PlanRequest& request) {
  for (const std::vector<double>* limits : {&request.lower, &request.upper}) {
    const auto found =
        std::find_if_not(limits->begin(), limits->end(), [](double x) { return std::isfinite(x); });
    if (found == limits->end()) continue;
    throw InvalidParameterError("no path can be planned: there are no limits for joint number " +
                                std::to_string(found - limits->begin() + 1));
  }
  if (!(request.time_limit > 0) || !std::isfinite(request.time_limit))
    throw InvalidParameterError("the time limit of a plan must be a number of seconds above 0");
  if (request.seed < 1 || request.seed > std::numeric_limits<std::uint32_t>::max())
    throw InvalidParameterError("the seed of a plan must be from 1 to 4294967295");
}

}  // namespace

const std::vector<std::string>& planner_names() {
  static const std::vector<std::string> kNames = {"rrt_connect", "bi_est", "rrt", "est"};
  return kNames;
}

PlannedPath plan_path(const PlanRequest& request) {
  const std::vector<std::string>& names = planner_names();
  if (std::find(names.begin(), names.end(), request.planner) == names.end())
    throw UnknownNameError("planner", request.planner, names);
  check_numbers(request);
  if (!has_planners())
    throw InvalidParameterError(
        "a path needs the planners of OMPL: apt-get install libompl-dev, then build again");
  EdgeChecker checker(request.robot, request.obstacles, request.options);
  check_end(checker, request, request.start, "start");
  check_end(checker, request, request.goal, "goal");
  return plan_by_ompl(request);
}

#ifndef RAYGAUGE_HAS_OMPL
bool has_planners() noexcept { return false; }

PlannedPath plan_by_ompl(const PlanRequest&) { return {}; }
#endif

}  // namespace raygauge
