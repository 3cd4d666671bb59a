// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/scene/scene_run.h"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <vector>

#include "engine/threads/team.h"
#include "scene/queries/cell_clock.h"
#include "scene/queries/effects.h"
#include "scene/queries/instant_run.h"
#include "scene/queries/nearest_run.h"
#include "scene/queries/rows.h"

namespace raygauge {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

void run_continuous(const Scene& scene, const ContinuousTask& task, PairSolver& solver,
                    SceneCellResult& result, const std::function<bool()>& stop) {
  const SceneQuery& query = scene.queries[static_cast<std::size_t>(task.query)];
  const auto body = [&](int number) { return &scene.bodies[static_cast<std::size_t>(number)]; };
  ContinuousQuestion question{*body(task.pair.a),
                              *body(task.pair.b),
                              query.metric,
                              query.metric.body >= 0 ? body(query.metric.body) : nullptr,
                              {}};
  question.options.from = scene.instants.front();
  question.options.to = scene.instants.back();
  question.options.contact = query.contact;
  question.options.tolerance = query.clearance_tolerance;
  question.options.stop = stop;
  SceneRecord row = begin_row(scene, task.query, task.pair);
  row.kind = task.effect;
  const Clock::time_point begin = Clock::now();
  const std::int64_t before = solver.counters().solves();
  entry_of(task.effect).answer(question, solver, row);
  row.solves = solver.counters().solves() - before;
  row.seconds = seconds_since(begin);
  result.tallies[static_cast<std::size_t>(task.query)].count(SceneDecision::solved);
  result.records.push_back(std::move(row));
}

// The work on one cell, of which a part is missing once `stop` was true.
SceneCellResult run_cell(const Scene& scene, const ScenePlan& plan, const Timeline& timeline,
                         std::uint64_t number, const std::function<bool()>& stop) {
  const SceneCell& cell = plan.cells[number];
  SceneCellResult result;
  result.cell = number;
  result.tallies.resize(scene.queries.size());
  const Clock::time_point begin = Clock::now();
  PairSolver solver(scene.dimension());
  for (std::size_t i = cell.first_task; i < cell.last_task && !(stop && stop()); ++i) {
    switch (cell.kind) {
      case SceneCellKind::instants:
        InstantRun(scene, timeline, plan.instant_tasks[i], solver, result, stop)
            .run(cell.first_instant, cell.last_instant);
        break;
      case SceneCellKind::nearest:
        find_nearest(scene, timeline, plan.nearest_queries[i], cell.first_instant, cell.last_instant, solver,
                     result, stop);
        break;
      case SceneCellKind::continuous:
        run_continuous(scene, plan.continuous_tasks[i], solver, result, stop);
        break;
    }
  }
  result.counters = solver.counters();
  result.seconds = seconds_since(begin);
  return result;
}

/// One run: its cells, shared between threads.
class SceneRun {
 public:
  SceneRun(const Scene& scene, const ScenePlan& plan, const SceneHooks& hooks, SceneSink& sink)
      : scene_(scene), plan_(plan), hooks_(hooks), sink_(sink), begin_(Clock::now()) {}

  SceneSummary run(int threads, const std::set<std::uint64_t>& done) {
    for (std::uint64_t cell = 0; cell < plan_.cells.size(); ++cell) {
      if (done.count(cell) == 0) cells_.push_back(cell);
    }
    summary_.threads = threads > 0 ? threads : omp_get_num_procs();
    clock_.emplace(plan_, cells_, summary_.threads);
    const Timeline timeline(scene_, summary_.threads, hooks_.stop);
    run_team(summary_.threads, {}, [&](int, int) {
      try {
        work(timeline);
      } catch (...) {
        failed_.store(true);
        throw;
      }
    });
    sink_.flush();
    summary_.stopped = summary_.stopped && summary_.cells_done < cells_.size();
    summary_.wall_seconds = seconds_since(begin_);
    return summary_;
  }

 private:
  static constexpr double kSecondsPerReport = 1;

  void work(const Timeline& timeline) {
    bool stopped = false;
    int asked = 0;
    // A clock, a signal and a lock at some questions only: a look may take a microsecond.
    const std::function<bool()> stop = [&] {
      constexpr int kQuestionsPerLook = 16;
      if (!stopped && asked++ % kQuestionsPerLook == 0) {
        stopped = hooks_.stop && hooks_.stop();
        report_within_cell();
      }
      return stopped;
    };
    while (!failed_.load()) {
      asked = 0;
      if (stop()) return stop_all();
      const std::uint64_t i = hooks_.next ? hooks_.next() : next_.fetch_add(1);
      if (i >= cells_.size()) return;
      {
        const std::lock_guard lock(mutex_);
        clock_->begin(i, seconds_since(begin_));
      }
      const SceneCellResult result = run_cell(scene_, plan_, timeline, cells_[i], stop);
      if (stopped) return stop_all();
      sink_.store(result);
      const std::lock_guard lock(mutex_);
      ++summary_.cells_done;
      clock_->end(i, seconds_since(begin_));
      report();
    }
  }

  void stop_all() {
    const std::lock_guard lock(mutex_);
    summary_.stopped = true;
  }

  // The mutex is locked.
  void report() {
    reported_at_ = seconds_since(begin_);
    if (!hooks_.progress) return;
    hooks_.progress({summary_.cells_done, cells_.size(), reported_at_, clock_->seconds_left(reported_at_)});
  }

  void report_within_cell() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock && seconds_since(begin_) >= reported_at_ + kSecondsPerReport) report();
  }

  const Scene& scene_;
  const ScenePlan& plan_;
  const SceneHooks& hooks_;
  SceneSink& sink_;
  Clock::time_point begin_;
  std::vector<std::uint64_t> cells_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;  ///< of what follows
  SceneSummary summary_;
  std::optional<CellClock> clock_;
  double reported_at_ = 0;
};

}  // namespace

SceneSummary run_scene(const Scene& scene, const ScenePlan& plan, int threads,
                       const std::set<std::uint64_t>& done, SceneSink& sink, const SceneHooks& hooks) {
  return SceneRun(scene, plan, hooks, sink).run(threads, done);
}

}  // namespace raygauge
