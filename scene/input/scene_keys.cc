// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/plan_table.h"
#include "scene/input/scene_robot.h"
#include "scene/input/scene_source.h"

namespace raygauge::cli {

const std::map<std::string, std::vector<std::string>>& scene_keys() {
  static const std::map<std::string, std::vector<std::string>> kKeys = {
      {"",
       {"name", "description", "dimension", "time", "dynamics", "body", "robot", "plan", "ignore", "query"}},
      {"time", {"from", "to", "instants"}},
      {"body",
       {"name", "group", "shape", "parts", "file", "as", "scale", "pose", "motion", "density", "mass",
        "inertia", "velocity", "angular_velocity"}},
      {"robot", robot_keys()},
      {"plan", plan_keys()},
      {"query",
       {"name", "between", "effects", "metric", "metric_body", "within", "nearest", "tolerance", "contact",
        "clearance_tolerance", "every_instant"}}};
  return kKeys;
}

}  // namespace raygauge::cli
