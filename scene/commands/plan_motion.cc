// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/commands/plan_motion.h"

#include <cstdio>
#include <sstream>

#include "raygauge/exceptions.h"
#include "results/text/language.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

std::string milliseconds(double seconds) {
  constexpr int kLength = 32;
  char text[kLength];
  std::snprintf(text, sizeof text, "%.3g ms", 1e3 * seconds);
  return text;
}

void check(const SceneSource& source) {
  if (!source.plan) throw InvalidParameterError("scene plan: the scene has no [plan]");
  const PlanTable& plan = *source.plan;
  if (!(source.scene.instants.front() < source.scene.instants.back()))
    throw InvalidParameterError("scene plan: the robot needs time to move: give [time] a to");
  if (plan.robot.own.has_trajectory) {
    throw InvalidParameterError("scene plan: robot '" + plan.robot.own.name +
                                "' has a trajectory already; leave out the key");
  }
  for (const Body& body : plan.request.obstacles) {
    if (!body.motion->is_static())
      throw InvalidParameterError("scene plan: '" + body.name +
                                  "' moves; a path is planned among bodies that stand");
  }
}

std::string summary_of(const PlanRequest& request, const PlannedPath& path, std::size_t configurations) {
  std::ostringstream text;
  text.precision(4);
  text << counted(configurations, "configuration") << ", length " << path.length << "; found by "
       << request.planner << " in " << milliseconds(path.search_seconds) << ", made shorter and smoother in "
       << milliseconds(path.shorten_seconds) << " ("
       << counted(static_cast<std::size_t>(path.motions), "edge") << " asked, " << path.undecided
       << " undecided), proven in " << milliseconds(path.proof_seconds);
  if (request.options.margin > 0) text << " with a clearance of " << request.options.margin;
  return text.str();
}

std::string csv_of(const Robot& robot, const JointTrajectory& trajectory) {
  std::ostringstream text;
  text.precision(17);
  text << "time";
  for (const std::string& joint : robot.joints) text << ',' << language::csv(joint);
  text << '\n';
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    text << trajectory.times[k];
    for (Eigen::Index i = 0; i < trajectory.values.rows(); ++i)
      text << ',' << trajectory.values(i, static_cast<Eigen::Index>(k));
    text << '\n';
  }
  return text.str();
}

}  // namespace

void add_planning_options(Command& command, PlanOptions& options) {
  command
      .add_option("--planner", options.planner,
                  "Planner of OMPL: rrt_connect, bi_est, rrt or est; default: that of [plan], or rrt_connect")
      .type_name("NAME");
  command
      .add_option("--time-limit", options.time_limit,
                  "Seconds for the search; default: those of [plan], or 10")
      .type_name("SECONDS");
  command.add_option("--seed", options.seed, "Seed of the planner; default: that of [plan], or 1")
      .type_name("S");
}

PlannedMotion plan_motion(SceneSource& source, const PlanOptions& options) {
  check(source);
  PlanTable& plan = *source.plan;
  if (options.planner) plan.request.planner = *options.planner;
  if (options.time_limit) plan.request.time_limit = *options.time_limit;
  if (options.seed) plan.request.seed = *options.seed;
  plan.request.stop = options.stop;
  PlannedMotion motion;
  motion.path = plan_path(plan.request);
  if (!motion.path.found()) return motion;
  motion.trajectory =
      plan.trajectory(motion.path, source.scene.instants.front(), source.scene.instants.back());
  plan.move(source.scene, motion.trajectory);
  motion.summary = summary_of(plan.request, motion.path, motion.trajectory.times.size());
  motion.csv = csv_of(plan.robot.own.robot, motion.trajectory);
  return motion;
}

}  // namespace raygauge::cli
