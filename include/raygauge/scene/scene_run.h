// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <set>

#include "raygauge/scene/scene_plan.h"
#include "raygauge/scene/scene_record.h"

namespace raygauge {

/// Where the cells of a scene go. Called by many threads at once.
class SceneSink {
 public:
  virtual ~SceneSink() = default;
  virtual void store(const SceneCellResult& cell) = 0;

  /// All cells given so far are safe when it returns. Called once, at the end of a run.
  virtual void flush() {}
};

struct SceneProgress {
  std::uint64_t cells_done = 0;  ///< of this run
  std::uint64_t cells_total = 0;
  double seconds = 0;
  double seconds_left = 0;  ///< expected, see scene/queries/cell_clock.h; 0 while nothing is known
};

struct SceneHooks {
  std::function<bool()>
      stop;  ///< true: end; what is in flight is dropped. Asked by all threads, within a cell too
  /// Returns 0, 1, …, each once to the threads of all processes: the number of the next cell among those not
  /// yet in `done`, which is the same in all. Empty: this process does all cells. Thread safe.
  std::function<std::uint64_t()> next;
  /// After each cell, and every second within cells; never by two threads at once.
  std::function<void(const SceneProgress&)> progress;
};

struct SceneSummary {
  std::uint64_t cells_done = 0;
  bool stopped = false;
  double wall_seconds = 0;
  int threads = 1;
};

/// Answers the queries of a scene, cell by cell on `threads` threads (0: one a core), except for the cells in
/// `done`. A cell's result depends on the scene alone. Rethrows the first exception, when all have ended.
SceneSummary run_scene(const Scene& scene, const ScenePlan& plan, int threads,
                       const std::set<std::uint64_t>& done, SceneSink& sink, const SceneHooks& hooks = {});

}  // namespace raygauge
