// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/motionbench_plans.h"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <time.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "raygauge/ompl.h"
#include "scene/planner/seeded_ompl.h"

namespace raygauge::bench {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

constexpr std::uint_fast32_t kSeed = 1;

/// Seconds since some moment.
double now(Clock clock) {
  timespec time{};
  ::clock_gettime(clock == Clock::processor ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Seconds of one call.
template <class Call>
double seconds_of(Clock clock, const Call& call) {
  const double begin = now(clock);
  call();
  return now(clock) - begin;
}

/// As ProvenMotionValidity, timed.
class TimedValidity final : public ob::MotionValidator {
 public:
  TimedValidity(const ob::SpaceInformationPtr& space, std::shared_ptr<EdgeCheckers> checkers, Clock clock,
                EdgeTimes& times)
      : MotionValidator(space), checkers_(std::move(checkers)), clock_(clock), times_(times) {}

  bool checkMotion(const ob::State* s1, const ob::State* s2) const override {
    if (!si_->satisfiesBounds(s2)) return false;
    const int joints = checkers_->joints();
    EdgeOutcome outcome = EdgeOutcome::undecided;
    const double seconds = seconds_of(clock_, [&] {
      outcome = checkers_->mine()
                    .edge(ompl_detail::values_of(s1, joints), ompl_detail::values_of(s2, joints))
                    .outcome;
    });
    if (outcome == EdgeOutcome::free) times_.free.push_back(seconds);
    if (outcome == EdgeOutcome::contact) times_.contact.push_back(seconds);
    if (outcome == EdgeOutcome::undecided) ++times_.undecided;
    return outcome == EdgeOutcome::free;
  }

  bool checkMotion(const ob::State* s1, const ob::State* s2,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(s1, s2)) return true;
    last_valid.second = 0;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, s1);
    return false;
  }

 private:
  std::shared_ptr<EdgeCheckers> checkers_;
  Clock clock_;
  EdgeTimes& times_;
};

ob::SpaceInformationPtr space_of(const Problem& problem, double resolution,
                                 const std::shared_ptr<EdgeCheckers>& checkers, Clock clock,
                                 EdgeTimes& times) {
  const auto joints = static_cast<unsigned>(problem.lower.size());
  const auto space = std::make_shared<ob::RealVectorStateSpace>(joints);
  ob::RealVectorBounds bounds(joints);
  bounds.low = problem.lower;
  bounds.high = problem.upper;
  space->setBounds(bounds);
  seed_samples(*space, kSeed);
  if (resolution > 0)
    space->setLongestValidSegmentFraction(space->getLongestValidSegmentFraction() * resolution);
  auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(std::make_shared<ProvenStateValidity>(information, checkers));
  if (resolution == 0)
    information->setMotionValidator(std::make_shared<TimedValidity>(information, checkers, clock, times));
  information->setup();
  return information;
}

JointTrajectory trajectory_of(const og::PathGeometric& path, std::size_t joints) {
  JointTrajectory trajectory;
  trajectory.values.resize(static_cast<Eigen::Index>(joints),
                           static_cast<Eigen::Index>(path.getStateCount()));
  for (std::size_t k = 0; k < path.getStateCount(); ++k) {
    const auto values =
        ompl_detail::values_of(path.getState(static_cast<unsigned>(k)), static_cast<int>(joints));
    trajectory.times.push_back(static_cast<double>(k));
    for (std::size_t i = 0; i < joints; ++i)
      trajectory.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = values[i];
  }
  return trajectory;
}

void search(const Problem& problem, double time_limit, Clock clock, EdgeTimes& times, Plan& plan) {
  const auto checkers = std::make_shared<EdgeCheckers>(problem.robot, problem.obstacles);
  const ob::SpaceInformationPtr space = space_of(problem, plan.resolution, checkers, clock, times);
  const auto definition = std::make_shared<ob::ProblemDefinition>(space);
  ob::ScopedState<ob::RealVectorStateSpace> start(space), goal(space);
  std::copy(problem.start.begin(), problem.start.end(), start->values);
  std::copy(problem.goal.begin(), problem.goal.end(), goal->values);
  definition->setStartAndGoalStates(start, goal);
  Seeded<og::RRTConnect> planner(space, kSeed);
  planner.setProblemDefinition(definition);
  shorten_steps(planner, *space->getStateSpace());
  planner.setup();
  const double end = now(clock) + time_limit;
  const ob::PlannerTerminationCondition time_is_over([&] { return now(clock) > end; });
  plan.search_seconds = seconds_of(
      clock, [&] { plan.solved = planner.solve(time_is_over) == ob::PlannerStatus::EXACT_SOLUTION; });
  plan.plan_seconds = plan.search_seconds;
  if (!plan.solved) return;
  og::PathGeometric path(static_cast<const og::PathGeometric&>(*definition->getSolutionPath()));
  plan.plan_seconds += seconds_of(clock, [&] {
    Seeded<og::PathSimplifier> simplifier(space, kSeed);
    simplifier.reduceVertices(path);
    simplifier.shortcutPath(path);
  });
  plan.path = trajectory_of(path, problem.start.size());
}

void prove(const Problem& problem, Clock clock, Plan& plan) {
  EdgeOptions options;
  options.witness = true;
  EdgeChecker checker(problem.robot, problem.obstacles, options);
  plan.proof_seconds = seconds_of(clock, [&] { plan.proof = checker.path(plan.path); });
  if (plan.proof.outcome == EdgeOutcome::free) return;
  plan.body_a = checker.name(plan.proof.body_a);
  plan.body_b = checker.name(plan.proof.body_b);
}

/// "" where start and goal are free; else what is wrong with them.
std::string wrong_end(const Problem& problem) {
  EdgeChecker checker(problem.robot, problem.obstacles);
  for (const bool is_start : {true, false}) {
    const std::vector<double>& q = is_start ? problem.start : problem.goal;
    const EdgeResult& result = checker.configuration(q);
    if (result.outcome == EdgeOutcome::free) continue;
    return std::string(is_start ? "start" : "goal") +
           (result.outcome == EdgeOutcome::contact ? " in contact" : " undecided") + ": " +
           checker.name(result.body_a) + " and " + checker.name(result.body_b);
  }
  return "";
}

}  // namespace

const char* word_of(EdgeOutcome outcome) {
  if (outcome == EdgeOutcome::free) return "free";
  return outcome == EdgeOutcome::contact ? "contact" : "undecided";
}

double Plan::length() const {
  double length = 0;
  for (Eigen::Index k = 0; k + 1 < path.values.cols(); ++k)
    length += (path.values.col(k + 1) - path.values.col(k)).norm();
  return length;
}

PlannedProblem plan_problem(const Problem& problem, const std::vector<double>& resolutions, double time_limit,
                            Clock clock) {
  PlannedProblem planned;
  planned.environment = problem.environment;
  planned.name = problem.name;
  planned.left_out = wrong_end(problem);
  if (!planned.left_out.empty()) return planned;
  for (const double resolution : resolutions) {
    Plan plan;
    plan.resolution = resolution;
    search(problem, time_limit, clock, planned.edges, plan);
    if (plan.solved) prove(problem, clock, plan);
    planned.plans.push_back(std::move(plan));
  }
  return planned;
}

}  // namespace raygauge::bench
