// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "results/run/run_directory.h"
#include "results/run/run_writer.h"
#include "results/scene/scene_file.h"

namespace raygauge {

/// The parts of an unfinished run of a scene, one small file a cell, in the folder TARGET.parts:
/// scene-000012.h5 holds cell 12 and all that describes the scene.
std::vector<std::filesystem::path> list_scene_parts(const std::filesystem::path& target);

/// A scene's results being written. Each cell lands as a file of its own, written aside and renamed; finish()
/// merges them into `path`. A run that is killed keeps every cell that has landed.
class SceneWriter final : public SceneSink {
 public:
  /// `head` holds what describes the scene, with one session, and no cells. Throws ResultsExistError,
  /// OtherExperimentError, RunLockedError or ResultsError, as RunWriter does.
  SceneWriter(const std::string& path, SceneFile head, RunMode mode);

  /// Cells that earlier sessions have stored.
  const std::set<std::uint64_t>& done() const noexcept { return done_; }

  void store(const SceneCellResult& cell) override;

  /// Merges what is stored into the file and removes the parts.
  void finish();

  /// What the run holds; after finish().
  const SceneFile& results() const noexcept { return all_; }

 private:
  void refuse_existing() const;
  void resume_existing();

  std::filesystem::path path_;
  RunMode mode_;
  SceneFile head_;
  SceneFile all_;
  RunDirectory directory_;
  std::set<std::uint64_t> done_;
  std::mutex mutex_;
  bool stored_any_ = false;
};

}  // namespace raygauge
