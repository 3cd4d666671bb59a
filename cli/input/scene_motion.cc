// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/scene_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <vector>

#include "cli/input/motion_file.h"
#include "cli/input/rotation_note.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_values.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

const std::vector<std::string> kPoseKeys = {"translation", "angle", "quaternion", "rpy", "rotation"};

Eigen::VectorXd vector_of(const toml::node& node, const std::string& key, int n) {
  Eigen::VectorXd v = read_vector(node, key);
  if (v.size() != n) refuse(node, key + " must have " + std::to_string(n) + " numbers");
  return v;
}

Eigen::MatrixXd rotation_of(const toml::table& table, int n, const std::string& key) {
  int given = 0;
  for (const char* name : {"angle", "quaternion", "rpy", "rotation"}) given += table.contains(name) ? 1 : 0;
  if (given > 1) refuse(table, key + ": give one of angle, quaternion, rpy and rotation");
  if (const toml::node* angle = table.get("angle")) {
    if (n != 2) refuse(*angle, key + ".angle belongs to 2 dimensions");
    return plane_rotation(read_number(*angle, key + ".angle"));
  }
  if (const toml::node* matrix = table.get("rotation")) {
    return rotation_with_note(place_of(*matrix) + ": " + key + ".rotation",
                              read_matrix(*matrix, key + ".rotation"));
  }
  const toml::node* quaternion = table.get("quaternion");
  const toml::node* rpy = table.get("rpy");
  const toml::node* turned = quaternion != nullptr ? quaternion : rpy;
  if (turned == nullptr) return Eigen::MatrixXd::Identity(n, n);
  if (n != 3) refuse(*turned, key + ": quaternion and rpy belong to 3 dimensions");
  if (quaternion != nullptr) {
    return from_quaternion(vector_of(*quaternion, key + ".quaternion", 4), place_of(*quaternion));
  }
  return rotation_of_rpy(vector_of(*rpy, key + ".rpy", 3));
}

Eigen::VectorXd translation_of(const toml::table& table, int n, const std::string& key) {
  const toml::node* node = table.get("translation");
  return node == nullptr ? Eigen::VectorXd::Zero(n) : vector_of(*node, key + ".translation", n);
}

Placement pose_of(const toml::table& table, int n, const std::string& key) {
  const Eigen::VectorXd t = translation_of(table, n, key);
  const Eigen::MatrixXd R = rotation_of(table, n, key);
  return placed(table, [&] { return make_placement(R, t); });
}

MotionPointer read_keyframes(const toml::node& node, int n) {
  const toml::array* list = node.as_array();
  if (list == nullptr) refuse(node, "motion.keyframes must be a list of tables");
  std::vector<double> times;
  std::vector<Placement> frames;
  std::vector<std::string> known = kPoseKeys;
  known.emplace_back("time");
  for (const toml::node& element : *list) {
    const toml::table* frame = element.as_table();
    if (frame == nullptr) refuse(element, "a keyframe must be a table with a time");
    reject_unknown_keys(*frame, "key of a keyframe", known);
    if (!frame->contains("time")) refuse(element, "a keyframe needs a time");
    times.push_back(read_number(*frame->get("time"), "keyframe.time"));
    frames.push_back(pose_of(*frame, n, "keyframe"));
  }
  return placed(node, [&]() -> MotionPointer { return std::make_shared<KeyframeMotion>(times, frames); });
}

MotionPointer read_rates(const toml::table& table, Placement first, int n, double start) {
  TwistMotion::Rates rates;
  rates.velocity.setZero(n);
  if (const toml::node* node = table.get("velocity")) rates.velocity = vector_of(*node, "motion.velocity", n);
  if (const toml::node* node = table.get("acceleration")) {
    rates.acceleration = vector_of(*node, "motion.acceleration", n);
  }
  if (const toml::node* node = table.get("spin")) {
    if (n == 2) rates.spin[2] = read_number(*node, "motion.spin");
    if (n != 2) rates.spin = vector_of(*node, "motion.spin", 3);
  }
  return placed(table, [&]() -> MotionPointer {
    return std::make_shared<TwistMotion>(std::move(first), rates, start);
  });
}

}  // namespace

Eigen::Matrix3d rotation_of_rpy(const Eigen::Vector3d& rpy) {
  return (Eigen::AngleAxisd(rpy[2], Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(rpy[1], Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(rpy[0], Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

Eigen::Matrix3d from_quaternion(const Eigen::Vector4d& wxyz, const std::string& place) {
  const Eigen::Quaterniond q(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  // What printing with 4 digits loses; anything farther from 1 is no rotation.
  constexpr double kLength = 1e-3;
  if (!(std::abs(q.norm() - 1) <= kLength)) {
    throw InvalidParameterError(place + ": the quaternion is not a rotation: its length is " +
                                std::to_string(q.norm()) + ", not 1");
  }
  return q.normalized().toRotationMatrix();
}

Placement read_pose(const toml::table& table, int dimension, const std::string& key) {
  reject_unknown_keys(table, "key of a pose", kPoseKeys);
  return pose_of(table, dimension, key);
}

Pose read_exact_pose(const toml::table& table, int dimension, const std::string& key) {
  reject_unknown_keys(table, "key of a pose", kPoseKeys);
  const Eigen::VectorXd t = translation_of(table, dimension, key);
  const Eigen::MatrixXd R = rotation_of(table, dimension, key);
  return placed(table, [&] { return Pose(R, t); });
}

MotionPointer read_motion(const toml::table& body, int dimension, const std::filesystem::path& folder,
                          double start) {
  Placement first = Placement::identity(dimension);
  if (const toml::node* node = body.get("pose")) {
    if (!node->is_table()) refuse(*node, "pose must be a table, as in { translation = [1, 2] }");
    first = read_pose(*node->as_table(), dimension, "pose");
  }
  const toml::node* node = body.get("motion");
  if (node == nullptr) return std::make_shared<StaticMotion>(first);
  const toml::table* table = node->as_table();
  if (table == nullptr) refuse(*node, "motion must be a table");
  reject_unknown_keys(*table, "key of a motion", {"keyframes", "file", "velocity", "acceleration", "spin"});
  const toml::node* keyframes = table->get("keyframes");
  const toml::node* file = table->get("file");
  if ((keyframes != nullptr || file != nullptr) && (body.contains("pose") || table->size() > 1)) {
    refuse(*node, "keyframes and file say all of a motion: give no pose, no rates and not both");
  }
  if (keyframes != nullptr) return read_keyframes(*keyframes, dimension);
  if (file != nullptr) {
    const std::string name = (folder / read_text(*file, "motion.file")).string();
    return placed(*file, [&] { return read_pose_file(name, dimension); });
  }
  return read_rates(*table, first, dimension, start);
}

}  // namespace raygauge::cli
