// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/motionbench_problems.h"
#include "bench/timed_medians.h"

namespace raygauge::bench {

/// Seconds of the edges of a search, by outcome.
struct EdgeTimes {
  std::vector<double> free, contact;
  std::int64_t undecided = 0;
};

/// "free", "contact" or "undecided".
const char* word_of(EdgeOutcome outcome);

/// One plan of one problem, and its proof.
struct Plan {
  double resolution = 0;  ///< of the default of OMPL; 0: proven
  bool solved = false;
  double search_seconds = 0, plan_seconds = 0, proof_seconds = 0;
  JointTrajectory path;
  EdgeResult proof;            ///< of the whole plan, by a checker that knows nothing of the search
  std::string body_a, body_b;  ///< of a contact

  double length() const;  ///< in the space of joints

  bool collides() const { return solved && proof.outcome == EdgeOutcome::contact; }
};

/// A problem, and what became of it.
struct PlannedProblem {
  std::string environment, name;
  std::string left_out;     ///< why: "goal in contact: hand and box"; then there is no plan
  std::vector<Plan> plans;  ///< one for each resolution
  EdgeTimes edges;          ///< of the proven search
};

/// Plans a problem by RRT-Connect once for each resolution, shortens what it finds, and proves it. The same
/// plans for the same problem, but for what the time limit ends, which is of the same clock as all times.
PlannedProblem plan_problem(const Problem& problem, const std::vector<double>& resolutions, double time_limit,
                            Clock clock);

}  // namespace raygauge::bench
