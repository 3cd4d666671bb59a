// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "cli/input/shapes.h"
#include "cli/input/toml_source.h"
#include "generators/files.h"

namespace raygauge::cli {

/// The sets of files below a folder, for the generator `files`. The few that were used last stay in memory;
/// of the others it is known what they were, and one that has changed is refused.
class FileSets final : public FileAccess {
 public:
  /// Relative names start at `folder`.
  explicit FileSets(std::filesystem::path folder) : folder_(std::move(folder)) {}

  SetFacts facts(const std::string& source, FileFormat format) override;
  std::shared_ptr<const ConvexSet> read(const std::string& source, FileFormat format) override;
  Pose pose(const std::string& text, int n) override;

 private:
  struct Entry {
    SetFacts facts;
    std::weak_ptr<const ConvexSet> set;
  };
  using Key = std::pair<std::string, FileFormat>;

  /// The entry of a set that is in memory, for as long as `held` lives.
  Entry& load(const Key& key, SetPointer& held);

  std::filesystem::path folder_;
  std::mutex mutex_;  ///< guards what follows, and lets one thread read at a time
  std::map<Key, Entry> entries_;
  std::deque<SetPointer> recent_;
};

/// The table of a pose as a text without blanks, {translation=[0,0,3]}, that FileSets::pose() reads. Throws
/// Error, with the place, for a value that no pose has.
std::string pose_text(const toml::table& table);

/// The table that the text describes. `place` is what messages begin with. Throws Error.
toml::table parse_pose(const std::string& text, const std::string& place);

}  // namespace raygauge::cli
