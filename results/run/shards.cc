// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/run/shards.h"

#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "results/disk/run_directory.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMark = ".shard-";
constexpr std::string_view kOf = "-of-";

std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return number;
}

/// The shard whose file, or folder of parts, has that name.
std::optional<Shard> shard_of(const fs::path& target, const std::string& name) {
  std::string_view rest = name;
  const std::string front = target.stem().string() + std::string(kMark);
  if (!rest.starts_with(front)) return std::nullopt;
  rest.remove_prefix(front.size());
  const std::optional<int> index = take_number(rest);
  if (!index || !rest.starts_with(kOf)) return std::nullopt;
  rest.remove_prefix(kOf.size());
  const std::optional<int> count = take_number(rest);
  if (!count) return std::nullopt;
  const Shard shard = {*index, *count};
  const fs::path file = shard_path(target, shard).filename();
  if (name != file.string() && name != parts_folder(file).string()) return std::nullopt;
  return shard;
}

}  // namespace

fs::path shard_path(const fs::path& target, const Shard& shard) {
  fs::path path = target;
  return path.replace_filename(target.stem().string() + std::string(kMark) + std::to_string(shard.index) +
                               std::string(kOf) + std::to_string(shard.count) + target.extension().string());
}

std::vector<ShardFile> list_shards(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::map<std::pair<int, int>, fs::path> found;
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, none)) {
    const std::optional<Shard> shard = shard_of(target, entry.path().filename().string());
    if (shard) found[{shard->count, shard->index}] = shard_path(target, *shard);
  }
  std::vector<ShardFile> shards;
  for (const auto& [key, path] : found) shards.push_back({{key.second, key.first}, path});
  return shards;
}

}  // namespace raygauge
