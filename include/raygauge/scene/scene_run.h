// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "raygauge/scene/scene.h"
#include "raygauge/scene/scene_record.h"

namespace raygauge {

/// One pair of bodies under one metric and tolerance, with every query about it at instants: what is computed
/// for one of them is used by the others.
struct InstantTask {
  BodyPair pair;
  std::vector<int> queries;
};

/// One effect of one query that asks about all of the time.
struct ContinuousTask {
  BodyPair pair;
  int query = 0;
  SceneEffects effect = SceneEffects::time_of_impact;
};

enum class SceneCellKind : std::uint8_t { instants, nearest, continuous };

/// A piece of work that is done, stored and resumed as a whole. It depends on nothing but the scene, so that
/// results are the same for any number of threads.
struct SceneCell {
  SceneCellKind kind = SceneCellKind::instants;
  std::size_t first_task = 0, last_task = 0;        ///< [first, last); of `nearest`: one query
  std::size_t first_instant = 0, last_instant = 0;  ///< [first, last)
};

/// What has to be computed to answer the queries of a scene.
struct ScenePlan {
  std::vector<InstantTask> instant_tasks;
  std::vector<int> nearest_queries;
  std::vector<ContinuousTask> continuous_tasks;
  std::vector<SceneCell> cells;
};

/// The plan of a scene. Throws as check_scene does.
ScenePlan plan_scene(const Scene& scene);

/// What a plan will compute for one query, what it will not, and why: one sentence a line, for people.
std::vector<std::string> explain_query(const Scene& scene, const ScenePlan& plan, int query);

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
