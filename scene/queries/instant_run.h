// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "raygauge/scene/scene_run.h"
#include "scene/queries/pair_solver.h"
#include "scene/queries/timeline.h"

namespace raygauge {

/// Answers what is asked of one pair at a run of instants, by the cheapest means that proves it: an answer
/// that still stands, the way that both have come since a bound, bounding balls, planes of before, a solve.
class InstantRun {
 public:
  /// `task` must outlive the object.
  InstantRun(const Scene& scene, const Timeline& timeline, const InstantTask& task, PairSolver& solver,
             SceneCellResult& result, const std::function<bool()>& stop);

  /// All instants in [first, last), in order. The instant before `first`, where there is one, is looked at
  /// but not recorded, so that what is recorded does not depend on where time is cut.
  void run(std::size_t first, std::size_t last);

 private:
  /// What is known of the pair at an instant.
  struct Known {
    SceneDecision decided = SceneDecision::solved;
    SceneStatus status = SceneStatus::undecided;
    bool beyond = false;                 ///< farther than any query cares; nothing more is known
    const PairAnswer* answer = nullptr;  ///< the solver's, which it keeps until it is asked again
    const PairAnswer* growth = nullptr;
    std::int64_t solves = 0;
    double seconds = 0;
  };

  void study_queries();
  void place(std::size_t k);
  void look(std::size_t k);
  std::size_t skip_from(std::size_t k, std::size_t last);
  bool stands_since(std::size_t k) const;
  bool prove_beyond(std::size_t k);
  void hold(std::size_t k, double lower, double rate, bool balls, SceneDecision later);
  void solve(std::size_t k);
  void solve_growth(std::size_t k);
  void write(std::size_t k);
  void write_row(std::size_t k, int query);
  bool is_within(const SceneQuery& query) const;
  bool is_recorded(const SceneQuery& query, SceneStatus before) const;

  const Scene& scene_;
  const Timeline& timeline_;
  const InstantTask& task_;
  PairSolver& solver_;
  SceneCellResult& result_;
  const std::function<bool()>& stop_;

  // What the queries of the task need together.
  bool exact_ = false;         ///< the distance at every instant
  bool any_distance_ = false;  ///< distances at some
  bool any_separation_ = false;
  bool closest_points_ = false;
  bool gradient_ = false;
  bool growth_ = false;
  bool depth_ = false;
  bool every_instant_ = false;
  double enough_ = 0;  ///< nobody cares how much farther than this the pair is

  PairMemory memory_;
  Known known_;
  std::size_t known_at_ = 0;
  bool known_any_ = false;
  bool placed_ = false;
  std::size_t held_until_ = 0;
  bool held_ = false;
  SceneDecision held_decision_ = SceneDecision::coherence;
  bool recording_ = false;
  bool first_ = true;
  SceneStatus status_before_ = SceneStatus::undecided;
};

}  // namespace raygauge
