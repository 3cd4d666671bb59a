// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "results/merge/merge_parts.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "results/disk/run_directory.h"
#include "results/exceptions.h"
#include "results/merge/row_file.h"
#include "results/run/encoding.h"
#include "results/run/identity.h"
#include "results/schema/schema.h"

namespace raygauge {
namespace fs = std::filesystem;
namespace {

/// What times depend on besides the machine.
std::string build_of(const Session& session) {
  const BuildInfo& build = session.build;
  std::string text = "raygauge " + build.raygauge_version + " commit " + build.git_commit +
                     (build.git_dirty ? " modified" : "") + ", " + build.compiler + " " +
                     build.compiler_flags + ", " + build.build_type;
  for (const ComponentVersion& component : session.versions) {
    text += ", " + component.name + " " + component.version;
  }
  return text;
}

class Merge {
 public:
  Merge(const std::vector<fs::path>& parts, const fs::path& target, const MergeOptions& options)
      : parts_(parts), target_(target), options_(options), spool_(target), reader_(spool_) {}

  MergeSummary run() {
    for (std::size_t i = 0; i < parts_.size(); ++i) add(static_cast<std::uint32_t>(i));
    sort_runs();
    if (expand_overlaps()) {
      sort_runs();
      drop_repeated();
    }
    count();
    if (!options_.partial && summary_.cells < summary_.provenance.cell_count) {
      throw ResultsError(target_.string() + ": not written: the parts hold " +
                         std::to_string(summary_.cells) + " of " +
                         std::to_string(summary_.provenance.cell_count) +
                         (summary_.provenance.cell_count == 1 ? " cell" : " cells") +
                         "; --partial merges them all the same");
    }
    write_rows(target_, summary_.provenance, spool_.runs(), spool_);
    return std::move(summary_);
  }

 private:
  void add(std::uint32_t part) {
    const fs::path& path = parts_[part];
    if (is_being_written(path))
      throw RunLockedError(path.string() + ": another process is writing this part");
    const auto first_session = static_cast<int>(summary_.provenance.sessions.size());
    if (list_parts(path).empty() && is_checked_of_this_version(path)) {
      add_provenance(path, decode_provenance(path));
      reader_.add_file(path, part, first_session);
    } else {
      ResultsFile results = read_results(path.string());  // unfinished, changed, or of an earlier release
      add_provenance(path, std::move(results.provenance));
      reader_.add_records(results.records, part, first_session);
    }
  }

  void add_provenance(const fs::path& path, Provenance provenance) {
    Provenance& merged = summary_.provenance;
    merged.has_checksum = merged.has_checksum && provenance.has_checksum;
    if (merged.identity.empty()) {
      merged.experiment_text = provenance.experiment_text;
      merged.identity = provenance.identity;
      merged.cell_count = provenance.cell_count;
    }
    const std::string difference = identity_difference(merged.identity, provenance.identity);
    if (!difference.empty()) {
      throw OtherExperimentError(path.string() + ": holds another experiment than " +
                                 parts_.front().string() + ": " + difference);
    }
    for (Session& session : provenance.sessions) {
      const std::string build = build_of(session);
      if (build_.empty()) build_ = build;
      if (!options_.mixed_builds && build != build_) {
        throw ResultsError(path.string() + ": made by another build than " + parts_.front().string() +
                           ", so that times do not compare: " + build + "; there " + build_ +
                           "; --mixed-builds merges them all the same");
      }
      merged.sessions.push_back(std::move(session));
    }
  }

  void sort_runs() {
    std::sort(spool_.runs().begin(), spool_.runs().end(), [](const RowRun& a, const RowRun& b) {
      return std::tie(a.cell, a.first, a.part, a.row) < std::tie(b.cell, b.first, b.part, b.row);
    });
  }

  static bool overlap(const RowRun& a, const RowRun& b) { return a.cell == b.cell && b.first <= a.last; }

  /// Splits the runs of cells of which parts hold the same repetitions into runs of one repetition; whether
  /// there are any.
  bool expand_overlaps() {
    const std::vector<RowRun> runs = spool_.runs();
    std::set<std::uint64_t> cells;
    for (std::size_t i = 1; i < runs.size(); ++i) {
      if (overlap(runs[i - 1], runs[i])) cells.insert(runs[i].cell);
    }
    if (cells.empty()) return false;
    spool_.runs().clear();
    for (const RowRun& run : runs) {
      if (cells.count(run.cell) == 0) {
        spool_.runs().push_back(run);
      } else {
        split(run);
      }
    }
    return true;
  }

  void split(const RowRun& run) {
    const std::size_t width = spool_.layout().row_bytes();
    const RowLayout::Field& repetition = spool_.layout().field("repetition");
    std::vector<char> rows(width * run.rows);
    spool_.read(run.row, run.rows, rows.data());
    std::vector<RowRun>& runs = spool_.runs();
    for (std::uint32_t i = 0; i < run.rows; ++i) {
      const auto number = entry_of<std::int32_t>(&rows[i * width], repetition);
      if (i == 0 || runs.back().first != number) {
        runs.push_back({run.cell, number, number, run.part, 0, run.row + i});
      }
      ++runs.back().rows;
    }
  }

  void drop_repeated() {
    const bool whole_only = repetitions_of_whole_cells(summary_.provenance.identity) == 1;
    std::vector<RowRun> kept;
    for (const RowRun& run : spool_.runs()) {
      const bool same_cell = !kept.empty() && kept.back().cell == run.cell;
      const bool repeated = same_cell && kept.back().first == run.first;
      if (repeated) require_same_answers(kept.back(), run);
      // A cell that repeated adaptively is that of one part, or it would mix two decisions when to end.
      const bool of_other_part = same_cell && whole_only && kept.back().part != run.part;
      if (repeated || of_other_part) {
        summary_.repeated += run.rows;
      } else {
        kept.push_back(run);
      }
    }
    spool_.runs() = std::move(kept);
  }

  void require_same_answers(const RowRun& a, const RowRun& b) {
    const std::string place = "cell " + std::to_string(a.cell) + ", repetition " + std::to_string(a.first) +
                              ": " + parts_[a.part].string() + " and " + parts_[b.part].string();
    if (a.rows != b.rows) throw ResultsError(place + " hold different methods");
    const std::size_t width = spool_.layout().row_bytes();
    std::vector<char> rows(2 * width * a.rows);
    spool_.read(a.row, a.rows, rows.data());
    spool_.read(b.row, b.rows, rows.data() + width * a.rows);
    for (std::uint32_t i = 0; i < a.rows; ++i) {
      require_same_row(&rows[i * width], &rows[(a.rows + i) * width], place);
    }
  }

  void require_same_row(const char* a, const char* b, const std::string& place) {
    RowLayout& layout = spool_.layout();
    const RowLayout::Field& status = layout.field("status");
    for (const char* row : {a, b}) {  // where the clock ended a solve, its answer is the clock's
      if (layout.texts(status).text(entry_of<std::uint32_t>(row, status)) == "time_limit") return;
    }
    for (const RowLayout::Field& field : layout.fields()) {
      if (field.circumstance || std::memcmp(a + field.offset, b + field.offset, field.bytes) == 0) continue;
      throw ResultsError(place + " contradict each other in " + field.column->name);
    }
  }

  void count() {
    const int repetitions = repetitions_of_whole_cells(summary_.provenance.identity);
    std::uint64_t cell = 0;
    int stored = 0;
    for (const RowRun& run : spool_.runs()) {
      summary_.records += run.rows;
      if (stored == 0 || run.cell != cell) stored = 0;
      cell = run.cell;
      const bool was_whole = stored >= repetitions;
      stored += run.last - run.first + 1;
      if (!was_whole && stored >= repetitions) ++summary_.cells;
    }
  }

  const std::vector<fs::path>& parts_;
  const fs::path& target_;
  const MergeOptions& options_;
  RowSpool spool_;
  RowReader reader_;
  MergeSummary summary_;
  std::string build_;
};

}  // namespace

MergeSummary merge_parts(const std::vector<fs::path>& parts, const fs::path& target,
                         const MergeOptions& options) {
  if (fs::exists(target))
    throw ResultsExistError(target.string() + ": exists already; merge into another file");
  if (!list_parts(target).empty()) {
    throw ResultsExistError(parts_folder(target).string() + ": holds cells of an unfinished run");
  }
  return Merge(parts, target, options).run();
}

}  // namespace raygauge
