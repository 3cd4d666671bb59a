// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "results/exceptions.h"
#include "results/run/atomic_file.h"
#include "results/run/identity.h"
#include "results/run/run_directory.h"
#include "results/scene/scene_writer.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

void require_same(const SceneFile& first, const SceneFile& part, const fs::path& path,
                  const MergeOptions& options) {
  const std::string difference = identity_difference(first.identity, part.identity);
  if (!difference.empty()) {
    throw OtherExperimentError(path.string() + ": holds another scene: " + difference);
  }
  if (options.mixed_builds || first.sessions.empty()) return;
  for (const Session& session : part.sessions) {
    const BuildInfo& here = session.build;
    const BuildInfo& there = first.sessions.front().build;
    if (here.git_commit == there.git_commit && here.raygauge_version == there.raygauge_version) continue;
    throw ResultsError(path.string() + ": made by another build: commit " + here.git_commit + ", " +
                       there.git_commit + " before; --mixed-builds merges them all the same");
  }
}

/// Adds the cells of `part` that `all` does not have yet.
void append_part(SceneFile& all, std::set<std::uint64_t>& known, const SceneFile& part) {
  const auto first_session = static_cast<std::int32_t>(all.sessions.size());
  all.sessions.insert(all.sessions.end(), part.sessions.begin(), part.sessions.end());
  for (SceneRow row : part.records) {
    if (known.count(row.cell) != 0) continue;
    row.session += first_session;
    all.records.push_back(std::move(row));
  }
  for (const SceneTallyRow& row : part.tallies) {
    if (known.count(row.cell) == 0) all.tallies.push_back(row);
  }
  for (const SceneCellRow& row : part.cells) {
    if (known.count(row.cell) == 0) all.cells.push_back(row);
  }
  for (const SceneCellRow& row : part.cells) known.insert(row.cell);
}

}  // namespace

SceneFile merge_scenes(const std::vector<fs::path>& parts, const fs::path& target,
                       const MergeOptions& options) {
  if (fs::exists(target) || !list_scene_parts(target).empty()) {
    throw ResultsExistError(target.string() + ": exists already; merge into another file");
  }
  SceneFile all;
  std::set<std::uint64_t> known;
  for (const fs::path& path : parts) {
    if (is_being_written(path)) {
      throw RunLockedError(path.string() + ": another process is writing this part");
    }
    SceneFile part = read_scene_file(path);
    if (&path == &parts.front()) {
      all = std::move(part);
      for (const SceneCellRow& row : all.cells) known.insert(row.cell);
      continue;
    }
    require_same(all, part, path, options);
    if (all.drawing.empty()) all.drawing = part.drawing;
    append_part(all, known, part);
  }
  if (!options.partial && !all.finished()) {
    throw ResultsError(target.string() + ": not written: the parts hold " + std::to_string(all.cells.size()) +
                       " of " + std::to_string(all.cell_count) + (all.cell_count == 1 ? " cell" : " cells") +
                       "; --partial merges them all the same");
  }
  sort_scene(all);
  write_atomically(target, encode_scene(all));
  return all;
}

}  // namespace raygauge
