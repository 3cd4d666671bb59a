// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/output/json_text.h"
#include "engine/sweep/pieces.h"

namespace raygauge::cli {

enum class ShardState { missing, unfinished, running, done };

/// How far a shard is.
struct ShardProgress {
  Shard shard;
  std::filesystem::path path;
  ShardState state = ShardState::missing;
  std::uint64_t instances_done = 0;
  std::uint64_t instances = 0;  ///< repetitions of cells
};

/// The shards of a run, all of one count, and the command that completes them.
struct ShardReport {
  std::string experiment;  ///< name
  std::vector<ShardProgress> shards;
  std::string completion;
};

/// The shards beside `target`; nothing where there is none. Of shards of several counts those of the count
/// that has most. Throws ResultsError for one that cannot be read.
std::optional<ShardReport> shard_report(const std::filesystem::path& target);

std::string shards_text(const ShardReport& report);
Json shards_json(const ShardReport& report);

}  // namespace raygauge::cli
