// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/robot_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "cli/input/input_file.h"
#include "raygauge/exceptions.h"
#include "results/text/words.h"
#include "scene/input/robot_formats.h"

namespace raygauge::cli {
namespace {

/// A format of robots, known by the root element of its files.
struct Format {
  std::string_view root;
  Robot (*read)(const RobotSource&);
};

constexpr std::array<Format, 3> kFormats = {
    {{"robot", urdf_robot}, {"mujoco", mjcf_robot}, {"sdf", sdf_robot}}};

}  // namespace

Robot read_robot(const std::string& path, const RobotMeshes& meshes) {
  const XmlFile file(read_text_input(path), path);
  for (const Format& format : kFormats) {
    if (format.root == file.root().Name()) return format.read({path, meshes, file});
  }
  file.refuse(file.root(), std::string("not a robot: its root is <") + file.root().Name() +
                               ">; <robot> (URDF), <mujoco> (MJCF) and <sdf> (SDF) are read");
}

std::vector<std::string> lines_of_left_out(const Robot& robot) {
  std::vector<std::string> lines;
  if (!robot.skipped.empty())
    lines.push_back("left out, for they are missing: " + listed(robot.skipped, ", "));
  if (!robot.left_out.empty()) lines.push_back("left out: " + listed(robot.left_out, "; "));
  return lines;
}

void check_has_meshes(const Robot& robot, const std::string& what) {
  if (robot.meshes == 0 && robot.skipped.empty())
    throw InvalidParameterError(what + " says how meshes are taken, and robot '" + robot.name + "' has none");
}

std::vector<JointLimits> limits_of(const Robot& robot) {
  std::vector<JointLimits> limits(robot.joints.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const TreeLink& step = robot.tree.links[i];
    if (step.kind == JointKind::fixed) continue;
    JointLimits& of = limits[static_cast<std::size_t>(step.joint)];
    if (step.kind == JointKind::revolute) of.turns = true;
    if (step.scale == 0) continue;
    const double one = (robot.links[i].lower - step.offset) / step.scale;
    const double other = (robot.links[i].upper - step.offset) / step.scale;
    of.lower = std::max(of.lower, std::min(one, other));
    of.upper = std::min(of.upper, std::max(one, other));
  }
  return limits;
}

JointLimits planning_limits(const JointLimits& limits, double start, double goal) {
  JointLimits range = limits;
  if (!range.turns) return range;
  if (!std::isfinite(range.lower)) range.lower = std::min(start, goal) - EIGEN_PI;
  if (!std::isfinite(range.upper)) range.upper = std::max(start, goal) + EIGEN_PI;
  return range;
}

}  // namespace raygauge::cli
