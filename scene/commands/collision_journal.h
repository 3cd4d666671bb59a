// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/disk/atomic_file.h"
#include "results/disk/file_lock.h"
#include "scene/planning/collision_matrix.h"

namespace raygauge::cli {

/// The pairs of a collision matrix that are proven, in a file that grows: JSON, one object a line. The first
/// line says which matrix it is, by a hash of robot, ranges, options and version; a kill loses at most the
/// pairs in work.
class CollisionJournal {
 public:
  /// Begins the file, or takes up what is in it. Throws ResultsError for a file of another kind or matrix,
  /// and RunLockedError while another process writes it.
  CollisionJournal(const std::string& path, const RobotModel& robot, const std::vector<JointRange>& ranges,
                   const CollisionMatrixOptions& options);

  const std::vector<LinkVerdict>& known() const noexcept { return known_; }

  /// Durably. Thread safe.
  void append(const LinkVerdict& verdict);

 private:
  FileLock lock_;
  std::vector<LinkVerdict> known_;
  std::optional<AppendedFile> file_;
};

}  // namespace raygauge::cli
