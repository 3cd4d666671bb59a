// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "engine/sweep/pieces.h"

namespace raygauge {

/// Where a shard of the run into `target` is written: x.h5 → x.shard-3-of-7.h5. A shard is a run of its own,
/// with its own parts and its own lock, so that shards on many machines need nothing of each other.
std::filesystem::path shard_path(const std::filesystem::path& target, const Shard& shard);

struct ShardFile {
  Shard shard;
  std::filesystem::path path;
};

/// The shards of `target` that are there, finished or not, by (count, index).
std::vector<ShardFile> list_shards(const std::filesystem::path& target);

}  // namespace raygauge
