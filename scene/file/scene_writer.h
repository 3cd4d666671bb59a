// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "results/disk/run_directory.h"
#include "results/merge/merge_parts.h"
#include "results/run/run_writer.h"
#include "scene/file/scene_batch.h"
#include "scene/file/scene_file.h"

namespace raygauge {

/// The parts of an unfinished run of a scene, small files in the folder TARGET.parts: scene-000012.h5 holds
/// cell 12, those that ended at about the same time, and all that describes the scene.
std::vector<std::filesystem::path> list_scene_parts(const std::filesystem::path& target);

/// A scene's results being written. Cells land in files, written aside and renamed, soon after they
/// end (SceneBatch); finish() merges them into `path`. A run that is killed keeps
/// every cell that has landed.
class SceneWriter final : public SceneSink {
 public:
  /// `head` holds what describes the scene, with one session for each process that works on it, this one's
  /// first, and no cells. Throws ResultsExistError,
  /// OtherExperimentError, RunLockedError or ResultsError, as RunWriter does.
  SceneWriter(const std::string& path, SceneFile head, RunMode mode);

  /// Cells that earlier sessions have stored.
  const std::set<std::uint64_t>& done() const noexcept { return done_; }

  /// Has what describes the scene on the disk before other processes store cells by a SceneRankSink; they
  /// have the sessions after this one.
  void begin();
  std::int32_t session() const noexcept { return session_; }

  /// Under force, lets go of the earlier run, before a part of a simulation is stored in the folder.
  void make_room();

  /// What is known once a scene has been simulated: the tables, the drawing and the number of cells.
  void set_simulated(SimulationTables tables, std::string drawing, std::uint64_t cell_count);

  void store(const SceneCellResult& cell) override;
  void flush() override { batch_.flush(); }

  /// Merges what is stored into the file and removes the parts.
  void finish();

  /// What the run holds; after finish().
  const SceneFile& results() const noexcept { return all_; }

 private:
  void refuse_existing() const;
  void resume_existing();
  void discard_earlier(const std::string& bytes);
  void store_part(SceneFile cells);

  std::filesystem::path path_;
  RunMode mode_;
  SceneFile head_;
  SceneFile all_;
  RunDirectory directory_;
  std::set<std::uint64_t> done_;
  std::mutex mutex_;
  std::int32_t session_ = 0;
  bool begun_ = false;  ///< for several processes
  bool stored_any_ = false;
  SceneBatch batch_;  // the last member: its thread uses the others
};

/// Cells of a process that works on a run which another one has begun.
class SceneRankSink final : public SceneSink {
 public:
  SceneRankSink(const std::filesystem::path& path, SceneFile head, std::int32_t session);

  void store(const SceneCellResult& cell) override { batch_.add(cell, session_); }
  void flush() override { batch_.flush(); }

 private:
  void store_part(SceneFile cells);

  std::filesystem::path folder_;
  SceneFile head_;
  std::int32_t session_;
  SceneBatch batch_;  // the last member: its thread uses the others
};

/// Joins parts of one scene, such as shards, into `target`, each cell once; `partial`: even if cells are
/// missing. Returns what was written. Throws as merge_parts() does, also where a cell that several parts have
/// differs in more than times.
SceneFile merge_scenes(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& target,
                       const MergeOptions& options);

}  // namespace raygauge
