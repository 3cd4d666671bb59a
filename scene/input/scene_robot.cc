// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/input/scene_robot.h"

#include <algorithm>
#include <map>
#include <memory>
#include <sstream>

#include "cli/input/mesh_object_file.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_section.h"
#include "raygauge/scene/scene_run.h"
#include "results/text/words.h"
#include "scene/input/motion_file.h"
#include "scene/input/scene_motion.h"

namespace raygauge::cli {
namespace {

using Trajectory = std::shared_ptr<const JointTrajectory>;

Trajectory all_zero(const Robot& robot, double from, double to) {
  auto still = std::make_shared<JointTrajectory>();
  still->times = {from, to > from ? to : from + 1};
  still->values = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(robot.joints.size()), 2);
  return still;
}

/// Links that a joint joins touch by design, also over links without a shape.
std::vector<std::pair<int, int>> joined_bodies(const Robot& robot, const std::map<int, int>& body_of_link) {
  std::vector<std::pair<int, int>> joined;
  for (const auto& [link, body] : body_of_link) {
    int parent = robot.tree.links[static_cast<std::size_t>(link)].parent;
    while (parent >= 0 && body_of_link.count(parent) == 0)
      parent = robot.tree.links[static_cast<std::size_t>(parent)].parent;
    if (parent >= 0) joined.emplace_back(body_of_link.at(parent), body);
  }
  return joined;
}

/// What the value of a joint is at its farthest beyond the limits; empty: within them.
std::string beyond_limits(const RobotLink& link, const TreeLink& step, const JointTrajectory& trajectory) {
  double farthest = 0, value = 0, time = 0;
  for (std::size_t k = 0; k < trajectory.times.size(); ++k) {
    const double q = step.scale * trajectory.values(step.joint, static_cast<Eigen::Index>(k)) + step.offset;
    const double beyond = std::max(link.lower - q, q - link.upper);
    if (!(beyond > farthest)) continue;
    farthest = beyond;
    value = q;
    time = trajectory.times[k];
  }
  if (!(farthest > 0)) return "";
  std::ostringstream text;
  text << link.joint << " is " << value << " at time " << time << ", its limits are " << link.lower << " and "
       << link.upper;
  return text.str();
}

std::string what_is_missing(const Robot& robot) {
  if (robot.skipped.empty()) return "";
  return " that is there; missing: " + robot.skipped.front() +
         (robot.skipped.size() > 1 ? " and " + std::to_string(robot.skipped.size() - 1) + " more" : "");
}

std::vector<std::string> notes_of(const Robot& robot, const std::string& name,
                                  const JointTrajectory& trajectory, bool has_trajectory) {
  std::vector<std::string> notes, beyond;
  for (const std::string& line : lines_of_left_out(robot)) notes.push_back("robot '" + name + "': " + line);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.tree.links[i].kind == JointKind::fixed) continue;
    const std::string joint = beyond_limits(robot.links[i], robot.tree.links[i], trajectory);
    if (!joint.empty()) beyond.push_back(joint);
  }
  if (!robot.notes.empty()) notes.push_back("robot '" + name + "': " + listed(robot.notes, "; "));
  if (!beyond.empty())
    notes.push_back("robot '" + name + "': joint values beyond their limits" +
                    (has_trajectory ? "" : " (without a trajectory every joint is at 0)") + ": " +
                    listed(beyond, "; "));
  return notes;
}

/// Adds the bodies of two links, if both have one.
void add_pair(int link_a, int link_b, const std::map<int, int>& body_of_link,
              std::vector<std::pair<int, int>>& pairs) {
  const auto a = body_of_link.find(link_a), b = body_of_link.find(link_b);
  if (a != body_of_link.end() && b != body_of_link.end()) pairs.emplace_back(a->second, b->second);
}

/// Adds the pairs that the SRDF file of the robot disables.
void take_semantics(const toml::node& node, const std::filesystem::path& folder,
                    const std::map<int, int>& body_of_link, RobotBodies& result) {
  const std::string path = (folder / read_text(node, "robot.srdf")).string();
  result.semantics = placed(node, [&] { return read_srdf(path, result.robot); });
  for (const DisabledPair& pair : result.semantics.disabled)
    add_pair(pair.link_a, pair.link_b, body_of_link, result.joined);
  if (!result.semantics.unknown.empty()) {
    result.notes.push_back("robot '" + result.name + "': its SRDF file names what the robot does not have: " +
                           listed(result.semantics.unknown, ", "));
  }
}

Robot robot_of(const toml::node& file, const std::string& path, const toml::node* as,
               const RobotMeshes& meshes) {
  if (as == nullptr) return placed(file, [&] { return read_robot(path, meshes); });
  RobotMeshes taken = meshes;
  taken.as = read_text(*as, "robot.as");
  check_way_to_take_a_mesh(taken.as, "robot.as", place_of(*as));
  Robot robot = placed(file, [&] { return read_robot(path, taken); });
  placed(*as, [&] { check_has_meshes(robot, "robot.as"); });
  return robot;
}

/// The key `file`, which files of before 0.3 call `urdf`.
const toml::node& file_of(const toml::table& table) {
  const toml::node* file = table.get("file");
  const toml::node* urdf = table.get("urdf");
  if (file != nullptr && urdf != nullptr)
    refuse(*urdf, "robot.file and robot.urdf are the same key: one is enough");
  if (file == nullptr && urdf == nullptr) refuse(table, "a robot needs the key file");
  return file != nullptr ? *file : *urdf;
}

class Records final : public SceneSink {
 public:
  void store(const SceneCellResult& cell) override {
    all.insert(all.end(), cell.records.begin(), cell.records.end());
  }
  std::vector<SceneRecord> all;
};

}  // namespace

const std::vector<std::string>& robot_keys() {
  static const std::vector<std::string> kKeys = {"name", "file", "urdf",       "as",
                                                 "srdf", "base", "trajectory", "group"};
  return kKeys;
}

RobotBodies read_robot_bodies(const toml::table& table, const std::filesystem::path& folder, double from,
                              double to, const RobotMeshes& meshes) {
  reject_unknown_keys(table, "[[robot]] key", robot_keys());
  const toml::node& file = file_of(table);
  const std::string path = (folder / read_text(file, "robot.file")).string();
  const Robot robot = robot_of(file, path, table.get("as"), meshes);
  RobotBodies result;
  result.name = robot.name;
  TomlSection(table, "robot").text("name", result.name);
  Placement base = Placement::identity(3);
  if (const toml::node* node = table.get("base"))
    base = read_pose(read_table(*node, "robot.base"), 3, "robot.base");
  Trajectory trajectory = all_zero(robot, from, to);
  const toml::node* given = table.get("trajectory");
  if (given != nullptr) {
    const std::string joints = (folder / read_text(*given, "robot.trajectory")).string();
    trajectory = placed(*given, [&] { return read_joint_file(joints, robot.joints, robot.without_value); });
  }
  const auto tree = std::make_shared<const KinematicTree>(robot.tree);
  std::map<int, int> body_of_link;
  for (int i = 0; i < static_cast<int>(robot.links.size()); ++i) {
    const RobotLink& link = robot.links[static_cast<std::size_t>(i)];
    if (link.shapes.empty()) continue;
    body_of_link[i] = static_cast<int>(result.bodies.size());
    result.links.push_back(i);
    const MotionPointer motion =
        placed(given == nullptr ? file : *given, [&] { return LinkMotion::make(tree, trajectory, base, i); });
    result.bodies.push_back(
        placed(table, [&] { return make_body(result.name + "/" + link.name, link.shapes, motion); }));
  }
  if (body_of_link.empty())
    refuse(file, "no link of the robot has a collision shape" + what_is_missing(robot));
  result.joined = joined_bodies(robot, body_of_link);
  for (const auto& [a, b] : robot.apart) add_pair(a, b, body_of_link, result.joined);
  result.notes = notes_of(robot, result.name, *trajectory, given != nullptr);
  result.robot = robot;
  result.base = base;
  result.has_trajectory = given != nullptr;
  if (const toml::node* node = table.get("srdf")) take_semantics(*node, folder, body_of_link, result);
  return result;
}

std::string note_of_contacts(const Scene& scene, const std::string& robot, int first, int count) {
  Scene start{scene.name, scene.bodies, {scene.instants.front()}, scene.ignored, {}};
  SceneQuery query;
  query.effects = SceneEffects::separated;
  for (int i = first; i < first + count; ++i) query.group_1.push_back(i);
  query.group_2 = query.group_1;
  start.queries = {query};
  std::vector<BodyPair> asked;
  for (const SceneQuery& other : scene.queries) {
    for (const BodyPair& pair : pairs_of(scene, other)) asked.push_back(pair);
  }
  std::sort(asked.begin(), asked.end());
  Records records;
  if (!pairs_of(start, query).empty() && !asked.empty()) run_scene(start, plan_scene(start), 1, {}, records);
  std::vector<std::string> pairs;
  for (const SceneRecord& record : records.all) {
    const BodyPair pair{record.body_a, record.body_b};
    if (record.status == SceneStatus::separated || !std::binary_search(asked.begin(), asked.end(), pair))
      continue;
    const auto name = [&](int body) {
      return "\"" + scene.bodies[static_cast<std::size_t>(body)].name + "\"";
    };
    pairs.push_back("[" + name(pair.a) + ", " + name(pair.b) + "]");
  }
  if (pairs.empty()) return "";
  std::string ignore;
  for (const std::string& pair : pairs) ignore += (ignore.empty() ? "" : ", ") + pair;
  return "robot '" + robot + "': " + counted(pairs.size(), "pair") +
         " of links in contact at the start; this leaves them out: ignore = [" + ignore + "]";
}

}  // namespace raygauge::cli
