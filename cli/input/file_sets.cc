// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/file_sets.h"

#include <unistd.h>

#include <cstddef>
#include <limits>

#include "cli/input/point_source.h"
#include "cli/input/pose_table.h"
#include "cli/input/set_source.h"
#include "cli/input/toml_keys.h"
#include "cli/input/toml_values.h"
#include "engine/queries/streamed_hull.h"
#include "raygauge/exceptions.h"
#include "raygauge/sets/point_set.h"

namespace raygauge::cli {
namespace {

/// As many as a dozen threads have in use.
constexpr std::size_t kMostRecent = 24;

SetFacts facts_of(const DigestedSet& read, const std::string& path) {
  SetFacts facts{read.set->dimension(), 1, read.digest};
  const PointSet* points = as_point_set(*read.set);
  const StreamedHull* streamed = as_streamed_hull(*read.set);
  if (points == nullptr && streamed == nullptr) return facts;
  const std::ptrdiff_t size = points != nullptr ? points->size() : streamed->size();
  if (size > std::numeric_limits<int>::max())
    throw InvalidParameterError(path + ": more points than a sweep can have");
  facts.N = static_cast<int>(size);
  facts.streamed = streamed != nullptr;
  return facts;
}

double half_of_memory() {
  return 0.5 * static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

std::string number_text(const toml::node& node, const std::string& key) {
  if (node.is_integer()) return std::to_string(*node.value<std::int64_t>());
  return to_string(ParameterValue(read_number(node, key)));
}

std::string value_text(const toml::node& node, const std::string& key) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return number_text(node, key);
  std::string text = "[";
  for (const toml::node& element : *list) text += (text.size() > 1 ? "," : "") + value_text(element, key);
  return text + "]";
}

}  // namespace

FileSets::Entry& FileSets::load(const Key& key, SetPointer& held) {
  Entry& entry = entries_[key];
  held = entry.set.lock();
  if (held != nullptr) return entry;
  const std::string path = (folder_ / key.first).string();
  const DigestedSet read = read_digested_set(
      path, {key.second.skip_header, "skip_header = true", key.second.stream ? 0 : half_of_memory()});
  const SetFacts facts = facts_of(read, path);
  const bool known = entry.facts.n > 0;
  if (known && facts.digest != entry.facts.digest)
    throw InvalidParameterError(path + ": its contents have changed since the sweep began");
  entry = {facts, read.set};
  held = read.set;
  recent_.push_back(held);
  if (recent_.size() > kMostRecent) recent_.pop_front();
  return entry;
}

SetFacts FileSets::facts(const std::string& source, FileFormat format) {
  const std::lock_guard lock(mutex_);
  const auto known = entries_.find({source, format});
  if (known != entries_.end() && known->second.facts.n > 0) return known->second.facts;
  SetPointer held;
  return load({source, format}, held).facts;
}

std::shared_ptr<const ConvexSet> FileSets::read(const std::string& source, FileFormat format) {
  const std::lock_guard lock(mutex_);
  SetPointer held;
  load({source, format}, held);
  return held;
}

Pose FileSets::pose(const std::string& text, int n) {
  return read_exact_pose(parse_pose(text, "pose"), n, "pose");
}

std::string pose_text(const toml::table& table) {
  std::string text = "{";
  for (const auto& [key, node] : table) {
    text += (text.size() > 1 ? "," : "") + std::string(key.str()) + "=" +
            value_text(node, "pose." + std::string(key.str()));
  }
  return text + "}";
}

toml::table parse_pose(const std::string& text, const std::string& place) {
  try {
    if (line_of_endless_key(text) > 0) throw InvalidParameterError(place + ": a pose has no such long keys");
    const toml::table document = toml::parse("pose=" + text, place);
    if (const toml::table* pose = document["pose"].as_table(); pose != nullptr && document.size() == 1)
      return *pose;
  } catch (const toml::parse_error&) {
  }
  throw InvalidParameterError(place + ": '" + text +
                              "' is not a pose, as in {translation = [0, 0, 3], rpy = [0, 0, 1.5]}");
}

}  // namespace raygauge::cli
