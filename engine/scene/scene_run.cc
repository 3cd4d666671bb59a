// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene_run.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <vector>

#include "engine/scene/instant_run.h"
#include "engine/scene/nearest_run.h"
#include "engine/threads/team.h"
#include "raygauge/scene/continuous.h"

namespace raygauge {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

SceneRecord row_of(const ContinuousTask& task) {
  SceneRecord row;
  row.query = task.query;
  row.body_a = task.pair.a;
  row.body_b = task.pair.b;
  return row;
}

void take_points(SceneRecord& row, const PairAnswer& answer) {
  row.part_a = answer.part_a;
  row.part_b = answer.part_b;
  row.point_a = answer.point_a;
  row.point_b = answer.point_b;
}

void find_impact(const Scene& scene, const ContinuousTask& task, const ContinuousOptions& options,
                 PairSolver& solver, SceneRecord& row) {
  const ImpactResult impact = time_of_impact(solver, scene.bodies[static_cast<std::size_t>(task.pair.a)],
                                             scene.bodies[static_cast<std::size_t>(task.pair.b)], options);
  row.kind = SceneRowKind::time_of_impact;
  row.time_lower = impact.lower;
  row.status = SceneStatus::undecided;
  if (impact.outcome == ImpactResult::Outcome::free) row.status = SceneStatus::free;
  if (impact.outcome != ImpactResult::Outcome::contact) return;
  row.status = SceneStatus::contact;
  row.time = row.time_upper = impact.upper;
  row.lower = impact.at_upper.lower;
  row.upper = impact.at_upper.upper;
  row.distance = impact.at_upper.value;
  take_points(row, impact.at_upper);
}

void find_clearance(const Scene& scene, const ContinuousTask& task, const ContinuousOptions& options,
                    PairSolver& solver, SceneRecord& row) {
  const SceneMetric& metric = scene.queries[static_cast<std::size_t>(task.query)].metric;
  const Body* metric_body = metric.body >= 0 ? &scene.bodies[static_cast<std::size_t>(metric.body)] : nullptr;
  const ClearanceResult found =
      clearance(solver, scene.bodies[static_cast<std::size_t>(task.pair.a)],
                scene.bodies[static_cast<std::size_t>(task.pair.b)], metric, metric_body, options);
  row.kind = SceneRowKind::clearance;
  row.time = found.time;
  row.lower = found.lower;
  row.upper = found.upper;
  row.distance = found.upper;
  row.status = SceneStatus::undecided;
  if (found.lower > 0) row.status = SceneStatus::separated;
  if (found.touches) row.status = SceneStatus::intersecting;
  take_points(row, found.at_time);
}

void run_continuous(const Scene& scene, const ContinuousTask& task, PairSolver& solver,
                    SceneCellResult& result) {
  const SceneQuery& query = scene.queries[static_cast<std::size_t>(task.query)];
  ContinuousOptions options;
  options.from = scene.instants.front();
  options.to = scene.instants.back();
  options.contact = query.contact;
  options.tolerance = query.clearance_tolerance;
  SceneRecord row = row_of(task);
  const Clock::time_point begin = Clock::now();
  const std::int64_t before = solver.counters().solves();
  if (task.effect == SceneEffects::time_of_impact) {
    find_impact(scene, task, options, solver, row);
  } else {
    find_clearance(scene, task, options, solver, row);
  }
  row.solves = solver.counters().solves() - before;
  row.seconds = seconds_since(begin);
  result.tallies[static_cast<std::size_t>(task.query)].count(SceneDecision::solved);
  result.records.push_back(std::move(row));
}

}  // namespace

SceneCellResult run_scene_cell(const Scene& scene, const ScenePlan& plan, const Timeline& timeline,
                               std::uint64_t number) {
  const SceneCell& cell = plan.cells[number];
  SceneCellResult result;
  result.cell = number;
  result.tallies.resize(scene.queries.size());
  const Clock::time_point begin = Clock::now();
  PairSolver solver(scene.dimension());
  for (std::size_t i = cell.first_task; i < cell.last_task; ++i) {
    switch (cell.kind) {
      case SceneCellKind::instants:
        InstantRun(scene, timeline, plan.instant_tasks[i], solver, result)
            .run(cell.first_instant, cell.last_instant);
        break;
      case SceneCellKind::nearest:
        find_nearest(scene, timeline, plan.nearest_queries[i], cell.first_instant, cell.last_instant, solver,
                     result);
        break;
      case SceneCellKind::continuous:
        run_continuous(scene, plan.continuous_tasks[i], solver, result);
        break;
    }
  }
  result.counters = solver.counters();
  result.seconds = seconds_since(begin);
  return result;
}

SceneSummary run_scene(const Scene& scene, const ScenePlan& plan, int threads,
                       const std::set<std::uint64_t>& done, SceneSink& sink, const SceneHooks& hooks) {
  const Clock::time_point begin = Clock::now();
  std::vector<std::uint64_t> cells;
  for (std::uint64_t cell = 0; cell < plan.cells.size(); ++cell) {
    if (done.count(cell) == 0) cells.push_back(cell);
  }
  SceneSummary summary;
  summary.threads = threads > 0 ? threads : omp_get_num_procs();
  const Timeline timeline(scene, summary.threads);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex mutex;
  const auto work = [&](int, int) {
    try {
      for (;;) {
        if (failed.load()) return;
        if (hooks.stop && hooks.stop()) {
          const std::lock_guard lock(mutex);
          summary.stopped = true;
          return;
        }
        const std::uint64_t i = hooks.next ? hooks.next() : next.fetch_add(1);
        if (i >= cells.size()) return;
        const SceneCellResult result = run_scene_cell(scene, plan, timeline, cells[i]);
        sink.store(result);
        const std::lock_guard lock(mutex);
        ++summary.cells_done;
        if (hooks.progress) hooks.progress({summary.cells_done, cells.size(), seconds_since(begin)});
      }
    } catch (...) {
      failed.store(true);
      throw;
    }
  };
  run_team(summary.threads, {}, work);
  sink.flush();
  summary.stopped = summary.stopped && summary.cells_done < cells.size();
  summary.wall_seconds = seconds_since(begin);
  return summary;
}

}  // namespace raygauge
