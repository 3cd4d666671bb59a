// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>

#include "raygauge/exceptions.h"
#include "raygauge/ompl.h"
#include "scene/planner/plan_path.h"
#include "scene/planner/seeded_ompl.h"

namespace raygauge {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::uint_fast32_t seed_of(const PlanRequest& request) {
  return static_cast<std::uint_fast32_t>(request.seed);
}

bool is_stopped(const PlanRequest& request) { return request.stop != nullptr && request.stop->load(); }

ob::SpaceInformationPtr space_of(const PlanRequest& request, const std::shared_ptr<EdgeCheckers>& checkers) {
  const auto joints = static_cast<unsigned>(request.lower.size());
  const auto space = std::make_shared<ob::RealVectorStateSpace>(joints);
  ob::RealVectorBounds bounds(joints);
  for (unsigned i = 0; i < joints; ++i) {
    bounds.setLow(i, request.lower[i]);
    bounds.setHigh(i, request.upper[i]);
  }
  space->setBounds(bounds);
  seed_samples(*space, seed_of(request));
  auto information = std::make_shared<ob::SpaceInformation>(space);
  set_proven_validity(information, checkers);
  information->setup();
  return information;
}

ob::PlannerPtr planner_of(const PlanRequest& request, const ob::SpaceInformationPtr& space) {
  const std::string& name = request.planner;
  const std::uint_fast32_t seed = seed_of(request);
  if (name == "rrt") return std::make_shared<Seeded<og::RRT>>(space, seed);
  if (name == "est") return std::make_shared<Seeded<og::EST>>(space, seed);
  if (name == "bi_est") return std::make_shared<Seeded<og::BiEST>>(space, seed);
  return std::make_shared<Seeded<og::RRTConnect>>(space, seed);
}

ob::ScopedState<> state_of(const ob::SpaceInformationPtr& space, const std::vector<double>& q) {
  ob::ScopedState<> state(space);
  for (unsigned i = 0; i < q.size(); ++i) state->as<ob::RealVectorStateSpace::StateType>()->values[i] = q[i];
  return state;
}

// By numbers of steps, not by time: the same seed gives the same path. A pass that finds it worse is not
// kept.
void shorten(const PlanRequest& request, const ob::SpaceInformationPtr& space, og::PathGeometric& path,
             double seconds) {
  constexpr int kPasses = 4, kSmoothings = 3;
  const Clock::time_point begin = Clock::now();
  const auto goes_on = [&] { return seconds_since(begin) < seconds && !is_stopped(request); };
  Seeded<og::PathSimplifier> simplifier(space, seed_of(request));
  for (int pass = 0; pass < kPasses && goes_on(); ++pass) {
    simplifier.reduceVertices(path);
    simplifier.shortcutPath(path);
    simplifier.collapseCloseVertices(path);
  }
  if (goes_on()) simplifier.smoothBSpline(path, kSmoothings);
}

DenseMatrix values_of(const og::PathGeometric& path, std::size_t joints) {
  DenseMatrix values(static_cast<Eigen::Index>(joints), static_cast<Eigen::Index>(path.getStateCount()));
  for (std::size_t k = 0; k < path.getStateCount(); ++k) {
    const auto* state = path.getState(static_cast<unsigned>(k))->as<ob::RealVectorStateSpace::StateType>();
    for (std::size_t i = 0; i < joints; ++i)
      values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = state->values[i];
  }
  return values;
}

/// The whole path once more, by a checker that knows nothing of the search.
void prove(const PlanRequest& request, PlannedPath& path) {
  if (path.values.cols() < 2) return;
  JointTrajectory trajectory;
  trajectory.values = path.values;
  for (Eigen::Index k = 0; k < path.values.cols(); ++k) trajectory.times.push_back(static_cast<double>(k));
  EdgeChecker checker(request.robot, request.obstacles, request.options);
  const Clock::time_point begin = Clock::now();
  const EdgeOutcome outcome = checker.path(trajectory).outcome;
  path.proof_seconds = seconds_since(begin);
  if (outcome != EdgeOutcome::free) throw Error("the path that was planned could not be proven again");
}

}  // namespace

bool has_planners() noexcept { return true; }

PlannedPath plan_by_ompl(const PlanRequest& request) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);  // its own lines are not for our users
  const auto checkers = std::make_shared<EdgeCheckers>(request.robot, request.obstacles, request.options);
  const ob::SpaceInformationPtr space = space_of(request, checkers);
  const auto problem = std::make_shared<ob::ProblemDefinition>(space);
  problem->setStartAndGoalStates(state_of(space, request.start), state_of(space, request.goal));
  problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(space));
  const ob::PlannerPtr planner = planner_of(request, space);
  planner->setProblemDefinition(problem);
  shorten_steps(*planner, *space->getStateSpace());
  planner->setup();
  PlannedPath found;
  Clock::time_point begin = Clock::now();
  const ob::PlannerTerminationCondition first_path([&] {
    return problem->hasExactSolution() || seconds_since(begin) > request.time_limit || is_stopped(request);
  });
  const bool solved = planner->solve(first_path) == ob::PlannerStatus::EXACT_SOLUTION;
  found.search_seconds = seconds_since(begin);
  if (solved) {
    og::PathGeometric path(static_cast<const og::PathGeometric&>(*problem->getSolutionPath()));
    begin = Clock::now();
    shorten(request, space, path, request.time_limit - found.search_seconds);
    found.shorten_seconds = seconds_since(begin);
    found.values = values_of(path, request.lower.size());
    found.length = path.length();
    prove(request, found);
  }
  const ob::MotionValidatorPtr& validator = space->getMotionValidator();
  found.motions = static_cast<std::int64_t>(validator->getCheckedMotionCount());
  found.undecided = checkers->undecided();
  return found;
}

}  // namespace raygauge
