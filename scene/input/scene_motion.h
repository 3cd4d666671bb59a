// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "cli/input/toml_source.h"
#include "raygauge/scene/motion.h"

namespace raygauge::cli {

/// The pose of a table that has nothing else (cli/input/pose_table.h), its rotation made exact. Throws Error,
/// with file and line.
Placement read_pose(const toml::table& table, int dimension, const std::string& key);

/// The motion that the tables `pose` and `motion` of a body describe: none, keyframes, a CSV file of poses,
/// or constant rates. Throws Error, with file and line.
MotionPointer read_motion(const toml::table& body, int dimension, const std::filesystem::path& folder,
                          double start);

}  // namespace raygauge::cli
