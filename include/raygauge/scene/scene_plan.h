// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "raygauge/scene/scene.h"

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

}  // namespace raygauge
