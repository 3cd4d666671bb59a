// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "raygauge/scene/scene.h"

namespace raygauge {

/// How an answer was obtained.
enum class SceneDecision : std::uint8_t {
  solved,       ///< by a solve at this instant
  broad_phase,  ///< by bounding balls, of this instant or an earlier one, and how far the balls have moved
                ///< since
  coherence,    ///< by a plane or a distance of an earlier instant, and how far the bodies have moved since
  standing,     ///< neither body has moved since an earlier answer, which is repeated
};

std::string_view to_string(SceneDecision decision) noexcept;

/// The outcome of a row.
enum class SceneStatus : std::uint8_t {
  separated,     ///< proven apart
  intersecting,  ///< proven to share a point
  undecided,     ///< so close to touching that the bounds do not tell, or a limit of precision
  contact,       ///< time of impact: there is one, between time_lower and time_upper
  free,          ///< time of impact: proven that there is none
};

std::string_view to_string(SceneStatus status) noexcept;

/// One answer. NaN: not asked for, or there is none.
struct SceneRecord {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  std::int32_t query = 0;
  std::int32_t body_a = 0, body_b = 0;
  std::int32_t part_a = -1, part_b = -1;   ///< the nearest parts; -1: not looked for
  SceneEffects kind = SceneEffects::none;  ///< the effect over the whole time; none: effects at an instant
  std::int64_t instant = -1;               ///< -1: of the whole time
  double time = kNone;        ///< of the instant; of the least clearance; of the contact, as time_upper
  double time_lower = kNone;  ///< no contact before it, proven: of an impact, and of a clearance of 0
  double time_upper = kNone;  ///< a contact at it, proven: of the same
  SceneStatus status = SceneStatus::undecided;
  SceneDecision decided = SceneDecision::solved;
  double distance = kNone, lower = kNone, upper = kNone;
  double growth = kNone, growth_lower = kNone, growth_upper = kNone;
  double depth = kNone, depth_lower = kNone, depth_upper = kNone;
  SmallVector point_a, point_b, gradient;  ///< empty: none
  std::int64_t solves = 0;  ///< pairs of convex parts solved for this row, and for rows that share its solve
  double seconds = 0;       ///< of those solves

  /// The distance; minus the depth of bodies that meet, where it was asked for.
  double signed_distance() const noexcept { return depth_lower > 0 ? -depth : distance; }
  double signed_lower() const noexcept { return depth_upper > 0 ? -depth_upper : lower; }
  double signed_upper() const noexcept { return depth_lower > 0 ? -depth_lower : upper; }

  bool at_instant() const noexcept { return kind == SceneEffects::none; }
};

/// A column of answers, as every table and file shows it.
struct SceneField {
  using Member = std::variant<std::int32_t SceneRecord::*, std::int64_t SceneRecord::*, double SceneRecord::*,
                              SceneEffects SceneRecord::*, SceneStatus SceneRecord::*,
                              SceneDecision SceneRecord::*, SmallVector SceneRecord::*>;
  Member member;
  std::string_view name;
  std::string_view unit;  ///< "1" of a number without one, "" of a text
  std::string_view text;  ///< what it means, in one line
  bool later = false;     ///< results files of earlier versions lack it
};

std::span<const SceneField> scene_fields() noexcept;

/// The texts of a record's kind, status and decision, and their inverse. Throws UnknownNameError.
std::string kind_text(SceneEffects kind);
SceneEffects kind_from(const std::string& text);
SceneStatus status_from(const std::string& text);
SceneDecision decision_from(const std::string& text);

/// How often the answers to one query were obtained in each way.
struct SceneTally {
  std::int64_t asked = 0;  ///< pairs × instants; pairs for continuous effects
  std::int64_t solved = 0;
  std::int64_t broad_phase = 0;
  std::int64_t coherence = 0;
  std::int64_t standing = 0;
  std::int64_t shared = 0;  ///< of the solved ones: taken from a solve of another query

  void count(SceneDecision decision, std::int64_t times = 1) noexcept;
  SceneTally& operator+=(const SceneTally& other);
  friend bool operator==(const SceneTally&, const SceneTally&) = default;
};

/// Counts of what was computed; tests use them to check that nothing else was.
struct SceneCounters {
  std::int64_t distance_solves = 0;    ///< distances of two convex parts
  std::int64_t separation_solves = 0;  ///< separation tests of two convex parts
  std::int64_t growth_solves = 0;      ///< growth distances of two convex parts
  std::int64_t depths = 0;             ///< depths of two convex parts that are not proven to be apart
  std::int64_t closest_points = 0;     ///< pairs of closest points
  std::int64_t gradients = 0;
  std::int64_t plane_tests = 0;      ///< tests whether an earlier separating plane still separates two parts
  std::int64_t ball_tests = 0;       ///< bounds on a distance from bounding balls
  std::int64_t support_queries = 0;  ///< by solves; the two of a plane test are not among them

  SceneCounters& operator+=(const SceneCounters& other);
  std::int64_t solves() const noexcept { return distance_solves + separation_solves + growth_solves; }
  friend bool operator==(const SceneCounters&, const SceneCounters&) = default;
};

/// What the work on one cell of a scene gave.
struct SceneCellResult {
  std::uint64_t cell = 0;
  std::vector<SceneRecord> records;
  std::vector<SceneTally> tallies;  ///< by query
  SceneCounters counters;
  double seconds = 0;
};

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
