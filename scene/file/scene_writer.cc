// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/file/scene_writer.h"

#include <cstdio>
#include <utility>

#include "results/disk/atomic_file.h"
#include "results/disk/run_directory.h"
#include "results/exceptions.h"
#include "results/run/identity.h"
#include "results/run/output_place.h"
#include "scene/file/simulation_store.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

constexpr PartKind kPart{"scene-"};
constexpr const char* kHeadName = "scene-head.h5";  ///< read after the cells: it adds sessions alone

// `cells` with what describes the scene.
SceneFile part_of(const SceneHead& head, SceneFile cells, bool drawing) {
  static_cast<SceneHead&>(cells) = head;
  if (!drawing) cells.drawing.clear();
  return cells;
}

}  // namespace

std::vector<fs::path> list_scene_parts(const fs::path& target) { return parts_named(target, kPart.prefix); }

SceneWriter::SceneWriter(const std::string& path, SceneFile head, RunMode mode)
    : path_(behind_links(path)),
      mode_(mode),
      head_(std::move(head)),
      directory_(path_),
      batch_([this](SceneFile cells) { store_part(std::move(cells)); }) {
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
  if (!list_scene_parts(path_).empty() || !list_simulation_parts(path_).empty() ||
      !directory_.parts().empty()) {
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
  session_ = static_cast<std::int32_t>(before.sessions.size());
  before.sessions.insert(before.sessions.end(), head_.sessions.begin(), head_.sessions.end());
  head_.sessions = before.sessions;
  all_ = std::move(before);
  all_.drawing = head_.drawing;
}

/// Under force the earlier run goes only once the disk has taken what is to stand in its place.
void SceneWriter::discard_earlier(const std::string& bytes) {
  directory_.require_room(bytes);
  for (const fs::path& old : list_scene_parts(path_)) fs::remove(old);
  fs::remove(path_);
}

void SceneWriter::begin() {
  const std::scoped_lock lock(mutex_);
  const std::string bytes = encode_scene(head_);
  if (mode_ == RunMode::force) discard_earlier(bytes);
  stored_any_ = true;
  begun_ = true;
  write_part(directory_.folder() / kHeadName, bytes);
}

void SceneWriter::make_room() {
  const std::scoped_lock lock(mutex_);
  if (mode_ != RunMode::force || stored_any_) return;
  discard_earlier(encode_scene(head_));
  for (const fs::path& old : list_simulation_parts(path_)) fs::remove(old);
  stored_any_ = true;
}

void SceneWriter::set_simulated(SimulationTables tables, std::string drawing, std::uint64_t cell_count) {
  const std::scoped_lock lock(mutex_);
  head_.cell_count = all_.cell_count = cell_count;
  head_.drawing = all_.drawing = std::move(drawing);
  all_.simulation = std::move(tables);
}

void SceneWriter::store(const SceneCellResult& cell) {
  {
    const std::scoped_lock lock(mutex_);
    append_cell(all_, cell, session_);
  }
  batch_.add(cell, session_);
}

// The first part of a session has the drawing for all.
void SceneWriter::store_part(SceneFile cells) {
  const std::scoped_lock lock(mutex_);  // HDF5 is not for several threads at once
  const fs::path path = directory_.folder() / part_name(kPart, cells.cells.front().cell);
  const std::string bytes = encode_scene(part_of(head_, std::move(cells), !stored_any_));
  if (mode_ == RunMode::force && !stored_any_) discard_earlier(bytes);
  stored_any_ = true;
  write_part(path, bytes);
}

void SceneWriter::finish() {
  batch_.flush();
  const std::scoped_lock lock(mutex_);
  const std::vector<fs::path> parts = list_scene_parts(path_);
  // A scene, or a shard, without work has stored nothing: under force what is there is not of this run.
  const bool replaces = mode_ == RunMode::force && !stored_any_;
  if (!replaces && parts.empty() && fs::exists(path_)) return;
  if (begun_) all_ = read_scene_file(path_);
  if (all_.drawing.empty()) all_.drawing = head_.drawing;
  for (auto i = static_cast<std::size_t>(session_); i < all_.sessions.size(); ++i) {
    all_.sessions[i].finished_at = utc_now();
  }
  sort_scene(all_);
  directory_.store_target(encode_scene(all_));
  for (const fs::path& part : parts) fs::remove(part);
}

SceneRankSink::SceneRankSink(const fs::path& path, SceneFile head, std::int32_t session)
    : folder_(parts_folder(behind_links(path))),
      head_(std::move(head)),
      session_(session),
      batch_([this](SceneFile cells) { store_part(std::move(cells)); }) {
  head_.sessions.clear();  // the process that began the run has stored them
  head_.drawing.clear();
}

void SceneRankSink::store_part(SceneFile cells) {
  const fs::path path = folder_ / part_name(kPart, cells.cells.front().cell);
  write_part(path, encode_scene(part_of(head_, std::move(cells), false)));
}

}  // namespace raygauge
