// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "cli/input/toml_source.h"
#include "raygauge/sets/pose.h"

namespace raygauge::cli {

/// A pose as files have it: translation, and one of angle (in the plane), quaternion [w, x, y, z], rpy (roll,
/// pitch, yaw as in URDF) or rotation (a matrix). Angles are in radians. What is left out is zero.
struct PoseEntry {
  Eigen::MatrixXd R;
  Eigen::VectorXd t;
};

/// The keys of such a table.
const std::vector<std::string>& pose_keys();

/// The pose that the table has among its keys. Throws Error, with file and line.
PoseEntry read_pose_entry(const toml::table& table, int dimension, const std::string& key);

/// The pose of a table that has nothing else, R as it is given. Throws Error, with file and line; also unless
/// RᵀR = 1 to 1e-12.
Pose read_exact_pose(const toml::table& table, int dimension, const std::string& key);

/// A vector of so many numbers. Throws Error, with file and line.
Eigen::VectorXd vector_of_length(const toml::node& node, const std::string& key, int n);

/// The rotation by roll, pitch and yaw: about x, then y, then z of the space, as in URDF.
Eigen::Matrix3d rotation_of_rpy(const Eigen::Vector3d& rpy);

/// The rotation of a quaternion. Throws InvalidParameterError, with `place`, if its length is farther from 1
/// than printing with 4 digits makes it.
Eigen::Matrix3d from_quaternion(const Eigen::Vector4d& wxyz, const std::string& place);

}  // namespace raygauge::cli
