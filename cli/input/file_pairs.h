// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/input/toml_source.h"
#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/instance.h"

namespace raygauge::cli {

/// The [[generator]] entry of `files`: which pairs of files a sweep takes, and how the sets are moved.
///
///     A = ["left/*.off", "clouds.h5:/*/left"]    # a source or a list; *, ? and [a-z] match names of files
///     Q = "right.obj"                            # every A with every Q, unless paired = true: A and Q are
///                                                # patterns, which pair what their * stand for
///     files = "meshes/*.off"                     # or: every ordered pair of two different ones
///     pairs = "pairs.csv"                        # or: one pair a line; the first line names the columns
///
/// and for either role scale_A, center_A and pose_A (a pose as in a scene): a value, or a list of them, which
/// is swept. Columns of the CSV file are A and Q and any of pair (a name), scale_A, …, pose_Q, exact_distance
/// (the truth) and exact_distance_rounding; all others are the user's own and become columns of the records.
///
/// Every pair becomes a generator with n and N of its own, and with digests of what its files hold.
/// Throws Error, with file and line: keys, files that are missing or cannot be read, sets of two dimensions.
std::vector<GeneratorSpec> read_file_pairs(const toml::table& entry, const std::filesystem::path& folder,
                                           const GeneratorRegistry& registry);

/// The name that read_file_pairs() is for.
inline constexpr const char* kFilesGenerator = "files";

}  // namespace raygauge::cli
