// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

#include "cli/input/point_file.h"

namespace raygauge::cli {

/// The points, n × N, of whatever `source` names: FILE.h5:/DATASET (rows are points), a mesh (.obj, .off,
/// .stl, .ply, or one of these with .gz: its vertices), or else a text file (see parse_points), "-" being
/// standard input. Throws Error.
Eigen::MatrixXd read_point_source(const std::string& source, const PointFormat& format = {});

}  // namespace raygauge::cli
