// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "bench/motionbench_problems.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

#include "raygauge/exceptions.h"
#include "scene/input/moveit_file.h"
#include "scene/planning/fixed_joints.h"

namespace raygauge::bench {

namespace fs = std::filesystem;

namespace {

fs::path only(const fs::path& folder, const std::string& extension) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) return entry.path();
  throw InvalidParameterError("there is no *" + extension + " in " + folder.string());
}

}  // namespace

Problems::Problems(const fs::path& folder) : folder_(folder / "problems") {
  if (fs::is_directory(folder_)) return;
  unpacked_ = fs::temp_directory_path() / ("raygauge_motionbench." + std::to_string(::getpid()));
  fs::create_directories(unpacked_);
  const std::string archive = (folder / "problems.tar.bz2").string(), into = unpacked_.string();
  std::string words[] = {"tar", "-xjf", archive, "-C", into};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(),
                       words[3].data(), words[4].data(), nullptr};
  pid_t child = 0;
  int status = 1;
  if (::posix_spawnp(&child, "tar", nullptr, nullptr, arguments, environ) == 0) ::waitpid(child, &status, 0);
  if (status != 0) throw InvalidParameterError("tar could not unpack " + archive);
  folder_ = unpacked_ / "problems";
}

Problems::~Problems() {
  std::error_code ignored;
  if (!unpacked_.empty()) fs::remove_all(unpacked_, ignored);
}

std::vector<fs::path> Problems::sorted(const fs::path& folder, const std::string& prefix) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with(prefix)) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

BenchRobot robot_of(const fs::path& folder) {
  BenchRobot bench;
  cli::RobotMeshes meshes;
  meshes.as = "hull";
  meshes.packages["meshes"] = (folder / "meshes").string();
  bench.robot = cli::read_robot(only(folder, ".urdf").string(), meshes);
  bench.semantics = cli::read_srdf(only(folder, ".srdf").string(), bench.robot);
  bench.model.base = Placement::identity(3);
  std::vector<int> body_of(bench.robot.links.size(), -1);
  for (std::size_t i = 0; i < bench.robot.links.size(); ++i) {
    if (bench.robot.links[i].shapes.empty()) continue;
    body_of[i] = static_cast<int>(bench.model.bodies.size());
    bench.model.bodies.push_back(
        {bench.robot.links[i].name, static_cast<int>(i), bench.robot.links[i].shapes});
  }
  bench.model.tree = bench.robot.tree;
  bench.model.ignored = joined_bodies(bench.model);
  for (const cli::DisabledPair& pair : bench.semantics.disabled) {
    const int a = body_of[static_cast<std::size_t>(pair.link_a)];
    const int b = body_of[static_cast<std::size_t>(pair.link_b)];
    if (a >= 0 && b >= 0) bench.model.ignored.emplace_back(a, b);
  }
  return bench;
}

Problem problem_of(const BenchRobot& bench, const fs::path& request_file) {
  const std::string number = request_file.stem().string().substr(std::string("request").size());
  const cli::MoveItRequest request = cli::read_moveit_request(request_file.string());
  Problem problem;
  problem.environment = request_file.parent_path().filename().string();
  problem.name = number;
  problem.obstacles =
      cli::read_moveit_scene((request_file.parent_path() / ("scene" + number + ".yaml")).string()).obstacles;
  const std::vector<bool>& moves = bench.semantics.group(request.group, request_file.string()).joints;
  const std::vector<cli::JointLimits> limits = cli::limits_of(bench.robot);
  std::vector<double> standing(moves.size(), 0.0);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::string& joint = bench.robot.joints[i];
    const auto start = request.start.find(joint), goal = request.goal.find(joint);
    if (start != request.start.end()) standing[i] = start->second;
    if (!moves[i]) continue;
    if (goal == request.goal.end())
      throw InvalidParameterError(request_file.string() + ": there is no goal for joint '" + joint + "'");
    problem.start.push_back(standing[i]);
    problem.goal.push_back(goal->second);
    const cli::JointLimits range = cli::planning_limits(limits[i], standing[i], goal->second);
    problem.lower.push_back(range.lower);
    problem.upper.push_back(range.upper);
  }
  problem.robot = bench.model;
  FixedJoints fixed = fix_joints(bench.robot.tree, standing, moves);
  problem.robot.tree = std::move(fixed.tree);
  problem.robot.joints = static_cast<int>(fixed.moving.size());
  return problem;
}

}  // namespace raygauge::bench
