// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "cli/input/hull_note.h"
#include "cli/input/point_file.h"
#include "cli/input/shapes.h"

namespace raygauge::cli {

inline constexpr std::size_t kMostSetFiles = 1000;

/// The set that `source` names: a set file (.toml, see read_set_file), or else the convex hull of points (see
/// read_point_source). Throws Error, also for a set file that names itself, be it over others, for more than
/// kDeepestSet set files inside one another and for more than kMostSetFiles files in all. `notes` as in
/// read_point_source. A dataset that `source` itself names may be streamed: PointFormat::streamed_from.
SetPointer read_set_source(const std::string& source, const PointFormat& format = {}, Notes* notes = nullptr);

/// The set, and a digest of what it was made from: the coordinates of points (of whatever format), the text
/// of a set file and what the files hold that it names.
struct DigestedSet {
  SetPointer set;
  std::uint64_t digest = 0;
};
DigestedSet read_digested_set(const std::string& source, const PointFormat& format = {});

}  // namespace raygauge::cli
