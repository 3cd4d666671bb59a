// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results/disk/file_lock.h"

namespace raygauge {

/// The files of a run that is not yet merged, in the folder TARGET.parts beside the results file TARGET:
///
///     session-0000.h5    one a session: who ran, where and when
///     cells-0000.csv     one a session: the records of the cells that it has finished (CellJournal)
///     lock               locked by the process that writes
///     *.tmp              being written; renamed when complete and on the disk
///
/// So a session is whole, whenever the process was killed, and of cells the one that was being appended is
/// not.
struct PartList {
  std::map<std::uint64_t, std::filesystem::path> journals;  ///< of cells, by session
  std::map<std::uint64_t, std::filesystem::path> sessions;  ///< by session

  bool empty() const noexcept { return journals.empty() && sessions.empty(); }
};

/// Of files that are being written.
inline constexpr std::string_view kTemporarySuffix = ".tmp";

/// How the parts of a kind are called: their number, in so many digits, stands between prefix and suffix.
struct PartKind {
  std::string_view prefix, suffix = ".h5";
  std::size_t digits = 6;
};
std::string part_name(const PartKind& kind, std::uint64_t number);

/// Replaces `path` in a folder of parts, as write_atomically() does.
void write_part(const std::filesystem::path& path, std::string_view bytes);

/// TARGET.parts.
std::filesystem::path parts_folder(const std::filesystem::path& target);

/// The files in it whose names begin with `prefix` and end with .h5, by name; none where there is no folder.
std::vector<std::filesystem::path> parts_named(const std::filesystem::path& target, std::string_view prefix);

/// The parts of `target` that are there; none where there is no folder.
PartList list_parts(const std::filesystem::path& target);

/// Where the cells of a session of `target` are written.
std::filesystem::path journal_path(const std::filesystem::path& target, std::uint64_t session);

/// Whether a process is writing the run of `target` now.
bool is_being_written(const std::filesystem::path& target);

/// The folder of parts, held by the one process that writes it, or that lets others write journals there.
class RunDirectory {
 public:
  /// Creates the folder (and the folders above it) where needed, locks it, and removes temporary files that a
  /// kill has left. Throws RunLockedError or ResultsError.
  explicit RunDirectory(std::filesystem::path target);

  /// Unlocks; removes the folder if it holds no parts.
  ~RunDirectory();
  RunDirectory(const RunDirectory&) = delete;
  RunDirectory& operator=(const RunDirectory&) = delete;

  const std::filesystem::path& folder() const noexcept { return folder_; }
  PartList parts() const { return list_parts(target_); }

  /// Throws RunLockedError if another process may have taken the folder.
  void require_held() const { lock_->require_held(); }

  /// Where the cells of a session are to be written.
  std::filesystem::path journal_path(std::uint64_t session) const;

  /// Durably writes the description of a session. Throws ResultsError; the one before it is then untouched.
  void store_session(std::uint64_t session, const std::string& bytes) const;

  /// Durably writes the target itself, by way of a temporary file in the folder. Throws ResultsError.
  void store_target(const std::string& bytes) const;

  /// Writes `bytes` to a temporary file and removes it. Throws ResultsError where the disk does not take
  /// them.
  void require_room(const std::string& bytes) const;

  /// Removes all parts, the sessions last.
  void clear() const;

 private:
  std::filesystem::path target_;
  std::filesystem::path folder_;
  std::optional<FileLock> lock_;
};

}  // namespace raygauge
