// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/input/point_file.h"
#include "cli/input/shapes.h"

namespace raygauge::cli {

/// The set that `source` names: a set file (.toml, see read_set_file), or else the convex hull of points (see
/// read_point_source). Throws Error, also for a set file that names itself, be it over others.
SetPointer read_set_source(const std::string& source, const PointFormat& format = {});

}  // namespace raygauge::cli
