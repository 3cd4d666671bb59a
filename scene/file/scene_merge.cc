// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "results/disk/atomic_file.h"
#include "results/disk/run_directory.h"
#include "results/exceptions.h"
#include "results/run/identity.h"
#include "scene/file/scene_writer.h"

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

bool same_entry(const Value& a, const Value& b) {
  const auto* x = std::get_if<double>(&a);
  const auto* y = std::get_if<double>(&b);
  if (x == nullptr || y == nullptr) return a == b;
  return std::bit_cast<std::uint64_t>(*x) == std::bit_cast<std::uint64_t>(*y);  // NaN is NaN
}

/// Two runs of a cell differ in their session and their times alone.
template <class Row>
void require_same_rows(const std::vector<Column<Row>>& columns, std::span<const Row> a,
                       std::span<const Row> b, const std::string& place) {
  if (a.size() != b.size()) throw ResultsError(place + " hold different numbers of answers");
  for (const Column<Row>& column : columns) {
    if (column.name == "session" || column.name == "seconds") continue;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (same_entry(column.get(a[i]), column.get(b[i]))) continue;
      throw ResultsError(place + " contradict each other in " + column.name);
    }
  }
}

/// Rows first, …, first + count - 1 of a table.
struct RowRange {
  std::size_t first = 0;
  std::size_t count = 0;

  template <class Row>
  std::span<const Row> of(const std::vector<Row>& rows) const {
    return std::span(rows).subspan(first, count);
  }
};

/// The rows of a cell in a table in order of cells.
template <class Row>
std::span<const Row> rows_of(const std::vector<Row>& rows, std::uint64_t cell) {
  const auto first =
      std::partition_point(rows.begin(), rows.end(), [cell](const Row& row) { return row.cell < cell; });
  const auto last =
      std::partition_point(first, rows.end(), [cell](const Row& row) { return row.cell == cell; });
  return {first, last};
}

/// Joins scenes: of a cell in several parts the first is kept, and the others must have the same answers.
class SceneJoin {
 public:
  void add(SceneFile part, const fs::path& path, const MergeOptions& options) {
    if (kept_.empty() && all_.sessions.empty()) {
      static_cast<SceneHead&>(all_) = part;
      all_.sessions.clear();
    } else {
      require_same(all_, part, path, options);
    }
    all_.has_checksum = all_.has_checksum && part.has_checksum;
    if (all_.drawing.empty()) all_.drawing = part.drawing;
    sort_scene(part);
    const auto first_session = static_cast<std::int32_t>(all_.sessions.size());
    all_.sessions.insert(all_.sessions.end(), part.sessions.begin(), part.sessions.end());
    for (SceneRow& row : part.records) row.session += first_session;
    for (const SceneCellRow& cell : part.cells) add_cell(part, cell, path);
  }

  SceneFile take() {
    sort_scene(all_);
    return std::move(all_);
  }

 private:
  /// Where a cell lies in the tables of all_, and whose it is.
  struct Kept {
    fs::path path;
    RowRange records;
    RowRange tallies;
    RowRange cell;
  };

  void add_cell(const SceneFile& part, const SceneCellRow& cell, const fs::path& path) {
    const auto records = rows_of(part.records, cell.cell);
    const auto tallies = rows_of(part.tallies, cell.cell);
    const auto found = kept_.find(cell.cell);
    if (found != kept_.end()) {
      const Kept& kept = found->second;
      const std::string place =
          "cell " + std::to_string(cell.cell) + ": " + kept.path.string() + " and " + path.string();
      require_same_rows(scene_record_columns(), kept.records.of(all_.records), records, place);
      require_same_rows(scene_tally_columns(), kept.tallies.of(all_.tallies), tallies, place);
      require_same_rows(scene_cell_columns(), kept.cell.of(all_.cells), std::span(&cell, 1), place);
      return;
    }
    kept_[cell.cell] = {path, appended(all_.records, records), appended(all_.tallies, tallies),
                        appended(all_.cells, std::span(&cell, 1))};
  }

  template <class Row>
  static RowRange appended(std::vector<Row>& rows, std::span<const Row> more) {
    const RowRange range{rows.size(), more.size()};
    rows.insert(rows.end(), more.begin(), more.end());
    return range;
  }

  SceneFile all_;
  std::map<std::uint64_t, Kept> kept_;
};

}  // namespace

SceneFile merge_scenes(const std::vector<fs::path>& parts, const fs::path& target,
                       const MergeOptions& options) {
  if (fs::exists(target) || !list_scene_parts(target).empty()) {
    throw ResultsExistError(target.string() + ": exists already; merge into another file");
  }
  SceneJoin join;
  for (const fs::path& path : parts) {
    if (is_being_written(path)) {
      throw RunLockedError(path.string() + ": another process is writing this part");
    }
    join.add(read_scene_file(path), path, options);
  }
  SceneFile all = join.take();
  if (!options.partial && !all.finished()) {
    throw ResultsError(target.string() + ": not written: the parts hold " + std::to_string(all.cells.size()) +
                       " of " + std::to_string(all.cell_count) + (all.cell_count == 1 ? " cell" : " cells") +
                       "; --partial merges them all the same");
  }
  write_atomically(target, encode_scene(all));
  return all;
}

}  // namespace raygauge
