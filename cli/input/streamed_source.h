// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "cli/input/shapes.h"

namespace raygauge::cli {

/// Bytes in double precision from which on a dataset had better be read by passes.
inline constexpr double kStreamedFrom = 1 << 28;

/// The hull of the rows of FILE.h5:/NAME, a StreamedHull, if they take so many bytes or more in double
/// precision and the file holds them as they are in memory; nullptr for every other source. Throws as
/// read_point_source does.
SetPointer open_streamed(const std::string& source, double from_bytes);

/// The digest of a set of open_streamed: one pass.
std::uint64_t digest_of_streamed(const ConvexSet& set);

}  // namespace raygauge::cli
