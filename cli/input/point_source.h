// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>

#include "cli/input/hull_note.h"
#include "cli/input/point_file.h"

namespace raygauge::cli {

/// The points, n × N, of whatever `source` names: FILE.h5:/DATASET (rows are points), a mesh (.obj, .off,
/// .stl, .ply, or one of these with .gz: its vertices), or else a text file (see parse_points), "-" being
/// standard input. `notes`, where they are wanted, say which meshes are not convex (hull_note). Throws Error.
Eigen::MatrixXd read_point_source(const std::string& source, const PointFormat& format = {},
                                  Notes* notes = nullptr);

}  // namespace raygauge::cli
