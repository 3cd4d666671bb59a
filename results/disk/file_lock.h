// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace raygauge {

/// An exclusive lock between processes, held while the object lives; the system releases it when the process
/// ends, however it ends.
class FileLock {
 public:
  /// Creates `path` and locks it. Throws RunLockedError (with the number of the process that holds the lock)
  /// or ResultsError.
  explicit FileLock(std::filesystem::path path);

  /// Throws RunLockedError if the lock is no longer ours: on a shared file system the file may have been
  /// removed or replaced, and another process may hold its successor.
  void require_held() const;

  /// Removes the file, if it is still ours, and unlocks.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  bool is_current() const;

  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Whether a process holds a lock on the file at `path`; false where it does not exist.
bool is_locked(const std::filesystem::path& path);

}  // namespace raygauge
