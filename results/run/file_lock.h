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

  /// Removes the file and unlocks.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  bool is_current() const;

  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace raygauge
