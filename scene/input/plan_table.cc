// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/plan_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/input/toml_refusal.h"
#include "cli/input/toml_section.h"
#include "raygauge/exceptions.h"
#include "scene/planning/fixed_joints.h"

namespace raygauge::cli {
namespace {

/// The state of that name, of the first group of the SRDF file that has one.
const std::map<int, double>& named_state(const toml::node& node, const std::string& key,
                                         const RobotSemantics& semantics) {
  const std::string name = read_text(node, "plan." + key);
  std::vector<std::string> known;
  for (const JointGroup& group : semantics.groups) {
    const auto found = group.states.find(name);
    if (found != group.states.end()) return found->second;
    for (const auto& [state, values] : group.states) known.push_back(state);
  }
  throw UnknownNameError("state of the SRDF file", name, known, place_of(node));
}

/// The values of joints by their names, or of a state; those that are not named are as `otherwise` has them.
std::vector<double> configuration(const toml::table& plan, const std::string& key, const RobotBodies& own,
                                  const std::vector<double>& otherwise) {
  const Robot& robot = own.robot;
  const toml::node* node = plan.get(key);
  std::vector<double> values = otherwise;
  if (node != nullptr && node->is_string()) {
    for (const auto& [joint, value] : named_state(*node, key, own.semantics))
      values[static_cast<std::size_t>(joint)] = value;
    return values;
  }
  if (node == nullptr || !node->is_table()) {
    refuse(node == nullptr ? plan : *node,
           "[plan] needs " + key + " = { JOINT = VALUE, ... }, or the name of a state");
  }
  const toml::table& table = *node->as_table();
  reject_unknown_keys(table, "joint in plan." + key, robot.joints);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const toml::node* value = table.get(robot.joints[i]))
      values[i] = read_real(*value, "plan." + key + "." + robot.joints[i], {-1e6, 1e6});
  }
  return values;
}

/// Start, goal and limits of the joints that move; the others must be the same at both.
void take_joints(const toml::table& table, const std::vector<double>& goal, const std::vector<bool>& moves,
                 PlanTable& plan) {
  const Robot& robot = plan.robot.own.robot;
  const std::vector<JointLimits> limits = limits_of(robot);
  PlanRequest& request = plan.request;
  for (std::size_t i = 0; i < goal.size(); ++i) {
    const std::string name = "joint '" + robot.joints[i] + "'";
    if (!moves[i] && goal[i] != plan.standing[i]) {
      refuse(table, name + " is not of the group, and start and goal of the plan have other values for it");
    }
    if (!moves[i]) continue;
    const double least = std::min(plan.standing[i], goal[i]), most = std::max(plan.standing[i], goal[i]);
    const JointLimits range = planning_limits(limits[i], plan.standing[i], goal[i]);
    if (!(std::isfinite(range.lower) && std::isfinite(range.upper)))
      refuse(table, name + " is shifted and has no limits: no path can be planned");
    if (least < range.lower || most > range.upper)
      refuse(table, "start or goal of the plan is beyond the limits of " + name);
    request.start.push_back(plan.standing[i]);
    request.goal.push_back(goal[i]);
    request.lower.push_back(range.lower);
    request.upper.push_back(range.upper);
  }
}

/// All joints, or those of the group.
std::vector<bool> moving_joints(const toml::table& table, const RobotBodies& own) {
  const toml::node* node = table.get("group");
  if (node == nullptr) return std::vector<bool>(own.robot.joints.size(), true);
  const std::vector<bool>& joints =
      own.semantics.group(read_text(*node, "plan.group"), place_of(*node)).joints;
  if (std::find(joints.begin(), joints.end(), true) == joints.end())
    refuse(*node, "no joint of that group takes a value");
  return joints;
}

const SceneRobot& robot_of(const toml::table& table, const std::vector<SceneRobot>& robots) {
  if (robots.empty()) refuse(table, "[plan] needs a [[robot]]");
  const toml::node* node = table.get("robot");
  if (node == nullptr) {
    if (robots.size() > 1) refuse(table, "[plan] needs robot, the name of one of the robots");
    return robots.front();
  }
  const std::string name = read_text(*node, "plan.robot");
  std::vector<std::string> known;
  for (const SceneRobot& robot : robots) {
    if (robot.own.name == name) return robot;
    known.push_back(robot.own.name);
  }
  throw UnknownNameError("robot", name, known, place_of(*node));
}

/// The robot's bodies first, then all others.
void take_bodies(const Scene& scene, const std::vector<bool>& moves, PlanTable& plan) {
  const SceneRobot& robot = plan.robot;
  PlanRequest& request = plan.request;
  const int count = static_cast<int>(robot.own.bodies.size());
  std::vector<int> numbers(scene.bodies.size());
  int next = count;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const bool own = i >= robot.first && i < robot.first + count;
    numbers[static_cast<std::size_t>(i)] = own ? i - robot.first : next++;
    if (!own) request.obstacles.push_back(scene.bodies[static_cast<std::size_t>(i)]);
  }
  RobotModel& model = request.robot;
  FixedJoints fixed = fix_joints(robot.own.robot.tree, plan.standing, moves);
  model.tree = std::move(fixed.tree);
  plan.moving = std::move(fixed.moving);
  model.joints = static_cast<int>(plan.moving.size());
  model.base = robot.own.base;
  for (int i = 0; i < count; ++i) {
    const int link = robot.own.links[static_cast<std::size_t>(i)];
    model.bodies.push_back({robot.own.bodies[static_cast<std::size_t>(i)].name, link,
                            robot.own.robot.links[static_cast<std::size_t>(link)].shapes});
  }
  for (const auto& [a, b] : scene.ignored) {
    model.ignored.emplace_back(numbers[static_cast<std::size_t>(a)], numbers[static_cast<std::size_t>(b)]);
  }
}

}  // namespace

const std::vector<std::string>& plan_keys() {
  static const std::vector<std::string> kKeys = {"robot",   "group",  "start",      "goal",
                                                 "planner", "margin", "time_limit", "seed"};
  return kKeys;
}

PlanTable read_plan(const toml::table& table, const Scene& scene, const std::vector<SceneRobot>& robots) {
  reject_unknown_keys(table, "[plan] key", plan_keys());
  PlanTable plan;
  plan.robot = robot_of(table, robots);
  PlanRequest& request = plan.request;
  const RobotBodies& own = plan.robot.own;
  const std::vector<bool> moves = moving_joints(table, own);
  plan.standing = configuration(table, "start", own, std::vector<double>(own.robot.joints.size(), 0.0));
  std::vector<double> otherwise(moves.size(), 0.0);
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (!moves[i]) otherwise[i] = plan.standing[i];
  const std::vector<double> goal = configuration(table, "goal", own, otherwise);
  if (const toml::node* node = table.get("planner")) {
    request.planner = read_text(*node, "plan.planner");
    const std::vector<std::string>& names = planner_names();
    if (std::find(names.begin(), names.end(), request.planner) == names.end())
      throw UnknownNameError("planner", request.planner, names, place_of(*node));
  }
  const TomlSection keys(table, "plan");
  keys.real("margin", {0, 1e6}, request.options.margin);
  keys.real("time_limit", {0, 1e9, true}, request.time_limit);
  keys.integer("seed", {1, 4294967295.0}, request.seed);
  take_joints(table, goal, moves, plan);
  take_bodies(scene, moves, plan);
  return plan;
}

// Columns that are equal take no time and are left out.
JointTrajectory PlanTable::trajectory(const PlannedPath& path, double from, double to) const {
  std::vector<Eigen::Index> kept = {0};
  std::vector<double> way = {0};
  for (Eigen::Index k = 1; k < path.values.cols(); ++k) {
    const double step = (path.values.col(k) - path.values.col(kept.back())).cwiseAbs().maxCoeff();
    if (!(step > 0)) continue;
    kept.push_back(k);
    way.push_back(way.back() + step);
  }
  if (kept.size() < 2) throw InvalidParameterError("start and goal of the plan are the same");
  JointTrajectory trajectory;
  trajectory.values.resize(static_cast<Eigen::Index>(standing.size()),
                           static_cast<Eigen::Index>(kept.size()));
  trajectory.values.colwise() =
      Vector(Vector::Map(standing.data(), static_cast<Eigen::Index>(standing.size())));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (std::size_t j = 0; j < moving.size(); ++j) {
      trajectory.values(moving[j], static_cast<Eigen::Index>(i)) =
          path.values(static_cast<Eigen::Index>(j), kept[i]);
    }
    trajectory.times.push_back(i + 1 == kept.size() ? to : from + way[i] / way.back() * (to - from));
  }
  return trajectory;
}

void PlanTable::move(Scene& scene, const JointTrajectory& trajectory) const {
  const auto tree = std::make_shared<const KinematicTree>(robot.own.robot.tree);
  const auto shared = std::make_shared<const JointTrajectory>(trajectory);
  for (std::size_t i = 0; i < robot.own.links.size(); ++i) {
    Body& body = scene.bodies[static_cast<std::size_t>(robot.first) + i];
    body.motion = LinkMotion::make(tree, shared, robot.own.base, robot.own.links[i]);
  }
}

void PlanTable::stand(Scene& scene) const {
  if (robot.own.has_trajectory) return;
  JointTrajectory still;
  still.times = {scene.instants.front(), scene.instants.front() + 1};
  still.values.resize(static_cast<Eigen::Index>(standing.size()), 2);
  still.values.colwise() = Vector(Vector::Map(standing.data(), static_cast<Eigen::Index>(standing.size())));
  move(scene, still);
}

}  // namespace raygauge::cli
