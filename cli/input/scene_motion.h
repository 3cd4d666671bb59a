// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "cli/input/toml_source.h"
#include "raygauge/scene/motion.h"
#include "raygauge/sets/pose.h"

namespace raygauge::cli {

/// A pose as a scene file has it: translation, and one of angle (in the plane), quaternion [w, x, y, z], rpy
/// (roll, pitch, yaw as in URDF) or rotation (a matrix). Angles are in radians. What is left out is zero.
/// Throws Error, with file and line.
Placement read_pose(const toml::table& table, int dimension, const std::string& key);

/// The same of any dimension, R as it is given. Throws Error also unless RᵀR = 1 to 1e-12.
Pose read_exact_pose(const toml::table& table, int dimension, const std::string& key);

/// The motion that the tables `pose` and `motion` of a body describe: none, keyframes, a CSV file of poses,
/// or constant rates. Throws Error, with file and line.
MotionPointer read_motion(const toml::table& body, int dimension, const std::filesystem::path& folder,
                          double start);

/// The rotation by roll, pitch and yaw: about x, then y, then z of the space, as in URDF.
Eigen::Matrix3d rotation_of_rpy(const Eigen::Vector3d& rpy);

/// The rotation of a quaternion. Throws InvalidParameterError, with `place`, if its length is farther from 1
/// than printing with 4 digits makes it.
Eigen::Matrix3d from_quaternion(const Eigen::Vector4d& wxyz, const std::string& place);

}  // namespace raygauge::cli
