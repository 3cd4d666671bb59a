// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/console/command_line.h"
#include "scene/input/scene_source.h"

namespace raygauge::cli {

/// Options of `scene plan` that take the place of keys of [plan].
struct PlanOptions {
  std::optional<std::string> planner;
  std::optional<double> time_limit;
  std::optional<std::int64_t> seed;
  const std::atomic<bool>* stop = nullptr;  ///< PlanRequest::stop
};

void add_planning_options(Command& command, PlanOptions& options);

/// A planned motion. All but the path is empty where none was found within the time limit.
struct PlannedMotion {
  PlannedPath path;            ///< of the joints that move
  JointTrajectory trajectory;  ///< of all joints, over the scene's time
  std::string summary;         ///< what there is to say of it
  std::string csv;             ///< as `trajectory` of a robot takes it
};

/// Plans what [plan] of the scene asks for and lets the robot move along the path over the scene's time
/// if a path is found. Throws Error for a scene without [plan], without time,
/// with a moving obstacle or a robot that has a trajectory, and what plan_path() throws.
PlannedMotion plan_motion(SceneSource& source, const PlanOptions& options);

}  // namespace raygauge::cli
