// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/plan_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/input/toml_refusal.h"
#include "cli/input/toml_values.h"
#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

/// The values of joints by their names; those that are not named are 0.
std::vector<double> configuration(const toml::table& plan, const std::string& key, const Robot& robot) {
  const toml::node* node = plan.get(key);
  if (node == nullptr || !node->is_table()) {
    refuse(node == nullptr ? plan : *node, "[plan] needs " + key + " = { JOINT = VALUE, ... }");
  }
  const toml::table& table = *node->as_table();
  reject_unknown_keys(table, "joint in plan." + key, robot.joints);
  std::vector<double> values(robot.joints.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const toml::node* value = table.get(robot.joints[i]))
      values[i] = read_real(*value, "plan." + key + "." + robot.joints[i], {-1e6, 1e6});
  }
  return values;
}

/// Limits of the joints that take a value, also those of joints that follow them. A joint that turns without
/// limits may go half a turn beyond start and goal.
void take_limits(const toml::table& table, const Robot& robot, PlanRequest& request) {
  const std::size_t joints = robot.joints.size();
  request.lower.assign(joints, -kInfinity);
  request.upper.assign(joints, kInfinity);
  std::vector<bool> turns(joints, false);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const TreeLink& step = robot.tree.links[i];
    if (step.kind == JointKind::fixed) continue;
    const auto joint = static_cast<std::size_t>(step.joint);
    if (step.kind == JointKind::revolute) turns[joint] = true;
    if (step.scale == 0) continue;
    const double one = (robot.links[i].lower - step.offset) / step.scale;
    const double other = (robot.links[i].upper - step.offset) / step.scale;
    request.lower[joint] = std::max(request.lower[joint], std::min(one, other));
    request.upper[joint] = std::min(request.upper[joint], std::max(one, other));
  }
  for (std::size_t i = 0; i < joints; ++i) {
    const double least = std::min(request.start[i], request.goal[i]);
    const double most = std::max(request.start[i], request.goal[i]);
    if (!turns[i] && !(std::isfinite(request.lower[i]) && std::isfinite(request.upper[i])))
      refuse(table, "joint '" + robot.joints[i] + "' is shifted and has no limits: no path can be planned");
    if (request.lower[i] == -kInfinity) request.lower[i] = least - EIGEN_PI;
    if (request.upper[i] == kInfinity) request.upper[i] = most + EIGEN_PI;
    if (least < request.lower[i] || most > request.upper[i])
      refuse(table, "start or goal of the plan is beyond the limits of joint '" + robot.joints[i] + "'");
  }
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
void take_bodies(const Scene& scene, const SceneRobot& robot, PlanRequest& request) {
  const int count = static_cast<int>(robot.own.bodies.size());
  std::vector<int> numbers(scene.bodies.size());
  int next = count;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const bool own = i >= robot.first && i < robot.first + count;
    numbers[static_cast<std::size_t>(i)] = own ? i - robot.first : next++;
    if (!own) request.obstacles.push_back(scene.bodies[static_cast<std::size_t>(i)]);
  }
  RobotModel& model = request.robot;
  model.tree = robot.own.robot.tree;
  model.joints = static_cast<int>(robot.own.robot.joints.size());
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
  static const std::vector<std::string> kKeys = {"robot",  "start",      "goal", "planner",
                                                 "margin", "time_limit", "seed"};
  return kKeys;
}

PlanTable read_plan(const toml::table& table, const Scene& scene, const std::vector<SceneRobot>& robots) {
  reject_unknown_keys(table, "[plan] key", plan_keys());
  PlanTable plan;
  plan.robot = robot_of(table, robots);
  PlanRequest& request = plan.request;
  request.start = configuration(table, "start", plan.robot.own.robot);
  request.goal = configuration(table, "goal", plan.robot.own.robot);
  if (const toml::node* node = table.get("planner")) {
    request.planner = read_text(*node, "plan.planner");
    const std::vector<std::string>& names = planner_names();
    if (std::find(names.begin(), names.end(), request.planner) == names.end())
      throw UnknownNameError("planner", request.planner, names, place_of(*node));
  }
  if (const toml::node* node = table.get("margin"))
    request.options.margin = read_real(*node, "plan.margin", {0, 1e6});
  if (const toml::node* node = table.get("time_limit"))
    request.time_limit = read_real(*node, "plan.time_limit", {0, 1e9, true});
  if (const toml::node* node = table.get("seed"))
    request.seed = read_integer(*node, "plan.seed", {1, 4294967295.0});
  take_limits(table, plan.robot.own.robot, request);
  take_bodies(scene, plan.robot, request);
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
  trajectory.values.resize(path.values.rows(), static_cast<Eigen::Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    trajectory.values.col(static_cast<Eigen::Index>(i)) = path.values.col(kept[i]);
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
  still.values.resize(static_cast<Eigen::Index>(request.start.size()), 2);
  still.values.colwise() =
      Vector(Vector::Map(request.start.data(), static_cast<Eigen::Index>(request.start.size())));
  move(scene, still);
}

}  // namespace raygauge::cli
