// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/scene/scene_writer.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "results/exceptions.h"
#include "results/run/atomic_file.h"
#include "results/run/identity.h"
#include "results/run/output_place.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPart = "scene-";

std::string part_name(std::uint64_t cell) {
  std::string number = std::to_string(cell);
  number.insert(0, number.size() < 6 ? 6 - number.size() : 0, '0');
  return std::string(kPart) + number + ".h5";
}

void append_cell(SceneFile& file, const SceneCellResult& cell, std::int32_t session) {
  for (const SceneRecord& record : cell.records) file.records.push_back({cell.cell, session, record});
  for (std::size_t q = 0; q < cell.tallies.size(); ++q) {
    if (cell.tallies[q].asked > 0)
      file.tallies.push_back({cell.cell, static_cast<std::int32_t>(q), cell.tallies[q]});
  }
  file.cells.push_back({cell.cell, cell.counters, cell.seconds});
}

}  // namespace

std::vector<fs::path> list_scene_parts(const fs::path& target) {
  std::vector<fs::path> parts;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(parts_folder(target), error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kPart) && name.ends_with(".h5")) parts.push_back(entry.path());
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

SceneWriter::SceneWriter(const std::string& path, SceneFile head, RunMode mode)
    : path_(behind_links(path)), mode_(mode), head_(std::move(head)), directory_(path_) {
  if (mode == RunMode::create) refuse_existing();
  if (mode == RunMode::resume) resume_existing();
  if (mode == RunMode::force && fs::exists(path_) && !is_scene_file(path_)) {
    throw ResultsExistError(path_.string() + ": not the results of a scene; not replaced even by --force");
  }
  if (all_.sessions.empty()) all_ = head_;
}

void SceneWriter::refuse_existing() const {
  if (fs::exists(path_)) {
    throw ResultsExistError(path_.string() + ": exists already; --resume completes it, --force replaces it");
  }
  if (!list_scene_parts(path_).empty() || !directory_.parts().empty()) {
    throw ResultsExistError(directory_.folder().string() +
                            ": holds an unfinished run; --resume continues it, --force discards it");
  }
}

void SceneWriter::resume_existing() {
  if (!fs::exists(path_) && list_scene_parts(path_).empty()) return;
  SceneFile before = read_scene_file(path_);
  const std::string difference = identity_difference(before.identity, head_.identity);
  if (!difference.empty()) {
    throw OtherExperimentError(path_.string() + ": holds another scene: " + difference);
  }
  for (const SceneCellRow& row : before.cells) done_.insert(row.cell);
  before.sessions.push_back(head_.sessions.front());
  head_.sessions = before.sessions;
  all_ = std::move(before);
  all_.drawing = head_.drawing;
}

void SceneWriter::store(const SceneCellResult& cell) {
  const auto session = static_cast<std::int32_t>(head_.sessions.size() - 1);
  const std::scoped_lock lock(mutex_);  // HDF5 is not for several threads at once
  SceneFile part = head_;
  if (stored_any_) part.drawing.clear();  // the first part of a session has it for all
  append_cell(part, cell, session);
  const std::string bytes = encode_scene(part);
  if (mode_ == RunMode::force && !stored_any_) {
    directory_.require_room(bytes);
    for (const fs::path& old : list_scene_parts(path_)) fs::remove(old);
    fs::remove(path_);
  }
  stored_any_ = true;
  const fs::path path = directory_.folder() / part_name(cell.cell);
  write_atomically(path, bytes, path.string() + std::string(kTemporarySuffix));
  append_cell(all_, cell, session);
}

void SceneWriter::finish() {
  const std::scoped_lock lock(mutex_);
  const std::vector<fs::path> parts = list_scene_parts(path_);
  if (parts.empty() && fs::exists(path_)) return;
  if (mode_ == RunMode::force && !stored_any_) return;
  all_.sessions.back().finished_at = utc_now();
  sort_scene(all_);
  directory_.store_target(encode_scene(all_));
  for (const fs::path& part : parts) fs::remove(part);
}

}  // namespace raygauge
