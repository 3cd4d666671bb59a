// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/input/toml_source.h"
#include "raygauge/scene/scene.h"
#include "scene/input/scene_robot.h"
#include "scene/planner/plan_path.h"

namespace raygauge::cli {

/// A robot of a scene.
struct SceneRobot {
  RobotBodies own;
  int first = 0;  ///< the number of its first body in the scene
};

/// What [plan] asks for: a path of one robot of the scene among its other bodies.
struct PlanTable {
  SceneRobot robot;
  PlanRequest request;           ///< of the joints that move
  std::vector<double> standing;  ///< values of all joints at the start
  std::vector<int> moving;       ///< the joints of the request, by their numbers in the robot

  /// All joints along a path over the time from `from` to `to`; the joint that moves fastest always does so
  /// at the same speed. Throws InvalidParameterError where start and goal are the same.
  JointTrajectory trajectory(const PlannedPath& path, double from, double to) const;

  /// The robot's bodies in the scene move along it from now on, or stand at the start unless they have a
  /// trajectory.
  void move(Scene& scene, const JointTrajectory& trajectory) const;
  void stand(Scene& scene) const;
};

/// The keys of [plan].
const std::vector<std::string>& plan_keys();

/// Reads [plan] of a scene whose bodies, robots and ignored pairs are known. Throws Error, with file and
/// line.
PlanTable read_plan(const toml::table& table, const Scene& scene, const std::vector<SceneRobot>& robots);

}  // namespace raygauge::cli
