// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

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
};

void add_planning_options(Command& command, PlanOptions& options);

/// A planned motion: what there is to say of it, and its configurations as CSV, as `trajectory` of a robot
/// takes them.
struct PlannedMotion {
  std::string summary;
  std::string csv;
};

/// Plans what [plan] of the scene asks for and lets the robot move along the path over the scene's time.
/// Nothing: no path was found within the time limit. Throws Error for a scene without [plan], without time,
/// with a moving obstacle or a robot that has a trajectory, and what plan_path() throws.
std::optional<PlannedMotion> plan_motion(SceneSource& source, const PlanOptions& options);

}  // namespace raygauge::cli
