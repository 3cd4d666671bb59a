// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/queries/effects.h"

namespace raygauge {
namespace {

// So many looks (pairs × instants) make a cell worth storing on its own.
constexpr std::size_t kLooksPerCell = 20'000;
constexpr std::size_t kMostPairsPerCell = 256;
// With fewer pairs than these, time is cut too, so that there is work for every thread.
constexpr std::size_t kPairsForAllThreads = 64;
constexpr std::size_t kInstantsPerCell = 128;
constexpr std::size_t kNearestInstantsPerCell = 32;
constexpr std::size_t kContinuousTasksPerCell = 8;

/// What queries must agree in to share the solves of a pair.
bool shares_solves(const SceneQuery& x, const SceneQuery& y) {
  return x.metric == y.metric && x.tolerance == y.tolerance;
}

void add_instant_tasks(const Scene& scene, ScenePlan& plan) {
  std::vector<std::vector<int>> sharing;  // queries, in classes
  for (int q = 0; q < static_cast<int>(scene.queries.size()); ++q) {
    const SceneQuery& query = scene.queries[static_cast<std::size_t>(q)];
    if (!has_effect(query.effects, kInstantEffects)) continue;
    if (query.nearest > 0) {
      plan.nearest_queries.push_back(q);
      continue;
    }
    const auto same = std::find_if(sharing.begin(), sharing.end(), [&](const std::vector<int>& members) {
      return shares_solves(scene.queries[static_cast<std::size_t>(members.front())], query);
    });
    if (same == sharing.end()) {
      sharing.push_back({q});
    } else {
      same->push_back(q);
    }
  }
  for (const std::vector<int>& members : sharing) {
    std::vector<std::pair<BodyPair, int>> asked;
    for (const int q : members) {
      for (const BodyPair pair : pairs_of(scene, scene.queries[static_cast<std::size_t>(q)])) {
        asked.emplace_back(pair, q);
      }
    }
    if (members.size() > 1) std::sort(asked.begin(), asked.end());
    const std::size_t first_task = plan.instant_tasks.size();
    plan.instant_tasks.reserve(first_task + asked.size());
    for (const auto& [pair, q] : asked) {
      const bool known = plan.instant_tasks.size() > first_task && plan.instant_tasks.back().pair == pair;
      if (!known) plan.instant_tasks.push_back({pair, {}});
      plan.instant_tasks.back().queries.push_back(q);
    }
  }
}

void add_continuous_tasks(const Scene& scene, ScenePlan& plan) {
  for (int q = 0; q < static_cast<int>(scene.queries.size()); ++q) {
    const SceneQuery& query = scene.queries[static_cast<std::size_t>(q)];
    for (const Effect& entry : all_effects()) {
      if (entry.answer == nullptr || !has_effect(query.effects, entry.effect)) continue;
      for (const BodyPair pair : pairs_of(scene, query))
        plan.continuous_tasks.push_back({pair, q, entry.effect});
    }
  }
}

void cut(ScenePlan& plan, SceneCellKind kind, std::size_t tasks, std::size_t tasks_per_cell,
         std::size_t instants, std::size_t instants_per_cell) {
  for (std::size_t task = 0; task < tasks; task += tasks_per_cell) {
    for (std::size_t k = 0; k < instants; k += instants_per_cell) {
      plan.cells.push_back(
          {kind, task, std::min(tasks, task + tasks_per_cell), k, std::min(instants, k + instants_per_cell)});
    }
  }
}

std::string counted(std::size_t count, const char* word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

std::size_t standing_pairs(const Scene& scene, const std::vector<BodyPair>& pairs) {
  const auto stands = [&](int body) {
    return scene.bodies[static_cast<std::size_t>(body)].motion->is_static();
  };
  return static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [&](const BodyPair& pair) { return stands(pair.a) && stands(pair.b); }));
}

/// Pairs of the query that an earlier query solves as well.
std::size_t shared_pairs(const ScenePlan& plan, int query) {
  return static_cast<std::size_t>(
      std::count_if(plan.instant_tasks.begin(), plan.instant_tasks.end(), [&](const InstantTask& task) {
        const bool member = std::find(task.queries.begin(), task.queries.end(), query) != task.queries.end();
        return member && task.queries.front() != query;
      }));
}

/// How the pairs of a query at instants are answered; empty for effects that need no line.
std::string means_at_instants(const SceneQuery& query) {
  if (query.nearest > 0) {
    return "nearest " + std::to_string(query.nearest) +
           ": pairs in the order of their bounding balls, until the next ball is farther than the worst";
  }
  if (std::isfinite(query.within)) {
    return "within " + std::to_string(query.within) +
           ": solved only where neither balls nor a plane of before prove that the pair is farther";
  }
  if (query.effects == SceneEffects::separated)
    return "separated: one test where neither balls nor a plane of before prove it; no distance";
  const bool measured = has_effect(query.effects, SceneEffects::distance | SceneEffects::closest_points |
                                                      SceneEffects::gradient | SceneEffects::depth);
  return measured ? "distance: one solve an instant for each pair that has moved" : "";
}

/// The names of the effects that the query does not ask for, with commas.
std::string effects_not_asked_for(const SceneQuery& query) {
  std::string names;
  for (const Effect& entry : all_effects()) {
    if (!has_effect(query.effects, entry.effect))
      names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  return names;
}

}  // namespace

ScenePlan plan_scene(const Scene& scene) {
  check_scene(scene);
  ScenePlan plan;
  add_instant_tasks(scene, plan);
  add_continuous_tasks(scene, plan);
  const std::size_t instants = scene.instants.size();
  const std::size_t pairs = plan.instant_tasks.size();
  const std::size_t pairs_per_cell = std::clamp<std::size_t>(kLooksPerCell / instants, 1, kMostPairsPerCell);
  cut(plan, SceneCellKind::instants, pairs, pairs_per_cell, instants,
      pairs < kPairsForAllThreads ? kInstantsPerCell : instants);
  cut(plan, SceneCellKind::nearest, plan.nearest_queries.size(), 1, instants, kNearestInstantsPerCell);
  cut(plan, SceneCellKind::continuous, plan.continuous_tasks.size(), kContinuousTasksPerCell, 1, 1);
  return plan;
}

std::vector<std::string> explain_query(const Scene& scene, const ScenePlan& plan, int number) {
  const SceneQuery& query = scene.queries[static_cast<std::size_t>(number)];
  const std::vector<BodyPair> pairs = pairs_of(scene, query);
  const bool instants = has_effect(query.effects, kInstantEffects);
  std::vector<std::string> lines;
  const auto add = [&](bool applies, const std::string& line) {
    if (applies) lines.push_back(line);
  };
  add(true, counted(pairs.size(), "pair") +
                (instants ? " at " + counted(scene.instants.size(), "instant") : " over the whole time"));
  const std::size_t standing = standing_pairs(scene, pairs);
  add(standing > 0 && instants, counted(standing, "pair") + " of bodies that stand still: once");
  const std::size_t shared = shared_pairs(plan, number);
  add(shared > 0, counted(shared, "pair") + " shared with a query before: no solves of their own");
  const std::string means = instants ? means_at_instants(query) : "";
  add(!means.empty(), means);
  for (const Effect& entry : all_effects())
    add(!entry.way.empty() && has_effect(query.effects, entry.effect), std::string(entry.way));
  const std::string never = effects_not_asked_for(query);
  add(!never.empty(), "never: " + never + " (not asked for)");
  return lines;
}

}  // namespace raygauge
