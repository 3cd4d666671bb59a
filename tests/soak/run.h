// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>

#include "tests/soak/worker.h"

namespace raygauge::soak {

/// What to run, and for how long.
struct RunOptions {
  std::int64_t solves = std::numeric_limits<std::int64_t>::max();
  double seconds = std::numeric_limits<double>::infinity();
  int threads = 1;
  std::uint64_t seed = 1;
  std::int64_t first_base = 0;
  double seconds_between_reports = 10;
};

/// How far a run is.
struct Progress {
  Tally tally;
  std::int64_t bases = 0;  ///< base instances begun
  double seconds = 0;
};

/// Runs until the solves, the seconds, a violation or `stop()` end it. `report` is called now and then, and
/// not from two threads at once.
struct RunResult {
  Progress progress;
  std::optional<Violation> violation;
};

RunResult run(const RunOptions& options, const std::function<bool()>& stop,
              const std::function<void(const Progress&)>& report);

/// The points of a file that save() wrote, one a column. Throws Error where there is none.
Eigen::MatrixXd load_points(const std::string& path);

/// Writes A.csv, Q.csv (17 digits, one point a line) and violation.txt to `folder`, which is made.
void save(const Violation& violation, const RunOptions& options, const std::string& folder);

}  // namespace raygauge::soak
