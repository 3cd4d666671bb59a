// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "raygauge/scene/edge_checker.h"
#include "raygauge/scene/scene.h"
#include "scene/input/robot_file.h"
#include "scene/input/srdf_file.h"

namespace raygauge::bench {

/// The folder of the problems of a MotionBenchMaker set, unpacked where they are packed.
class Problems {
 public:
  explicit Problems(const std::filesystem::path& folder);
  ~Problems();
  Problems(const Problems&) = delete;
  Problems& operator=(const Problems&) = delete;

  /// What in a folder begins with `prefix`, sorted.
  static std::vector<std::filesystem::path> sorted(const std::filesystem::path& folder,
                                                   const std::string& prefix);

  const std::filesystem::path& folder() const noexcept { return folder_; }

 private:
  std::filesystem::path folder_, unpacked_;
};

/// A problem: joints of the group, bodies, start and goal.
struct Problem {
  std::string environment, name;
  RobotModel robot;
  std::vector<Body> obstacles;
  std::vector<double> start, goal, lower, upper;
};

/// The robot of a folder, and what its files leave out.
struct BenchRobot {
  cli::Robot robot;
  cli::RobotSemantics semantics;
  RobotModel model;
};

/// The robot of a folder: *.urdf, *.srdf and meshes/.
BenchRobot robot_of(const std::filesystem::path& folder);

/// The problem of requestNNNN.yaml and sceneNNNN.yaml beside it.
Problem problem_of(const BenchRobot& bench, const std::filesystem::path& request_file);

}  // namespace raygauge::bench
