// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/pose_table.h"

#include <Eigen/Geometry>
#include <cmath>

#include "cli/input/rotation_note.h"
#include "cli/input/toml_refusal.h"
#include "cli/input/toml_values.h"
#include "raygauge/exceptions.h"

namespace raygauge::cli {
namespace {

Eigen::MatrixXd rotation_of(const toml::table& table, int n, const std::string& key) {
  int given = 0;
  for (const char* name : {"angle", "quaternion", "rpy", "rotation"}) given += table.contains(name) ? 1 : 0;
  if (given > 1) refuse(table, key + ": give one of angle, quaternion, rpy and rotation");
  if (const toml::node* angle = table.get("angle")) {
    if (n != 2) refuse(*angle, key + ".angle belongs to 2 dimensions");
    return Eigen::Rotation2Dd(read_number(*angle, key + ".angle")).toRotationMatrix();
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
    return from_quaternion(vector_of_length(*quaternion, key + ".quaternion", 4), place_of(*quaternion));
  }
  return rotation_of_rpy(vector_of_length(*rpy, key + ".rpy", 3));
}

Eigen::VectorXd translation_of(const toml::table& table, int n, const std::string& key) {
  const toml::node* node = table.get("translation");
  return node == nullptr ? Eigen::VectorXd::Zero(n) : vector_of_length(*node, key + ".translation", n);
}

}  // namespace

const std::vector<std::string>& pose_keys() {
  static const std::vector<std::string> kKeys = {"translation", "angle", "quaternion", "rpy", "rotation"};
  return kKeys;
}

Eigen::VectorXd vector_of_length(const toml::node& node, const std::string& key, int n) {
  Eigen::VectorXd v = read_vector(node, key);
  if (v.size() != n) refuse(node, key + " must have " + std::to_string(n) + " numbers");
  return v;
}

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

PoseEntry read_pose_entry(const toml::table& table, int n, const std::string& key) {
  const Eigen::VectorXd t = translation_of(table, n, key);
  return {rotation_of(table, n, key), t};
}

Pose read_exact_pose(const toml::table& table, int dimension, const std::string& key) {
  reject_unknown_keys(table, "key of a pose", pose_keys());
  const PoseEntry pose = read_pose_entry(table, dimension, key);
  return placed(table, [&] { return Pose(pose.R, pose.t); });
}

}  // namespace raygauge::cli
