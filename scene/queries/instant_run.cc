// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/instant_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/numerics/floating_point.h"
#include "scene/queries/rows.h"

namespace raygauge {
namespace {

constexpr SceneEffects kDistanceEffects =
    SceneEffects::distance | SceneEffects::closest_points | SceneEffects::gradient | SceneEffects::depth;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

SceneStatus status_of(Separation separation) {
  switch (separation) {
    case Separation::separated:
      return SceneStatus::separated;
    case Separation::intersecting:
      return SceneStatus::intersecting;
    case Separation::undecided:
      break;
  }
  return SceneStatus::undecided;
}

}  // namespace

InstantRun::InstantRun(const Scene& scene, const Timeline& timeline, const InstantTask& task,
                       PairSolver& solver, SceneCellResult& result, const std::function<bool()>& stop)
    : scene_(scene), timeline_(timeline), task_(task), solver_(solver), result_(result), stop_(stop) {
  const SceneQuery& query = scene.queries[static_cast<std::size_t>(task.queries.front())];
  solver_.set_tolerance(query.tolerance);
  solver_.bind(scene.bodies[static_cast<std::size_t>(task.pair.a)],
               scene.bodies[static_cast<std::size_t>(task.pair.b)], query.metric);
  study_queries();
}

void InstantRun::study_queries() {
  for (const int q : task_.queries) {
    const SceneQuery& query = scene_.queries[static_cast<std::size_t>(q)];
    closest_points_ |= has_effect(query.effects, SceneEffects::closest_points);
    gradient_ |= has_effect(query.effects, SceneEffects::gradient);
    depth_ |= has_effect(query.effects, SceneEffects::depth);
    growth_ |= has_effect(query.effects, SceneEffects::growth);
    any_separation_ |= has_effect(query.effects, SceneEffects::separated);
    every_instant_ |= query.every_instant;
    const bool limited = std::isfinite(query.within);
    if (has_effect(query.effects, kDistanceEffects) || limited) {
      any_distance_ = true;
      exact_ |= !limited;
      enough_ = std::max(enough_, query.within);
    }
  }
}

void InstantRun::run(std::size_t first, std::size_t last) {
  constexpr unsigned kLooksPerStop = 16;
  first_ = first == 0;
  unsigned looks = 0;
  for (std::size_t k = first == 0 ? 0 : first - 1; k < last; ++k) {
    if (++looks % kLooksPerStop == 0 && stop_ && stop_()) return;
    recording_ = k >= first;
    placed_ = false;
    look(k);
    write(k);
    status_before_ = known_.status;
    if (!recording_) continue;
    first_ = false;
    k = skip_from(k, last);
  }
}

// Instants at which what is held proves all that is asked for, and nothing is recorded.
std::size_t InstantRun::skip_from(std::size_t k, std::size_t last) {
  if (!known_.beyond || !held_ || growth_ || every_instant_) return k;
  const std::size_t end = std::min(held_until_, last - 1);
  if (end <= k) return k;
  const bool stands = stands_since(end);
  for (const int q : task_.queries) {
    result_.tallies[static_cast<std::size_t>(q)].count(stands ? SceneDecision::standing : held_decision_,
                                                       static_cast<std::int64_t>(end - k));
  }
  return end;
}

void InstantRun::place(std::size_t k) {
  if (placed_) return;
  const SceneMetric& metric = scene_.queries[static_cast<std::size_t>(task_.queries.front())].metric;
  Placement metric_at;
  if (metric.body >= 0) metric_at = timeline_.placement(metric.body, k);
  solver_.place(timeline_.placement(task_.pair.a, k), timeline_.placement(task_.pair.b, k),
                metric.body >= 0 ? &metric_at : nullptr);
  placed_ = true;
}

bool InstantRun::stands_since(std::size_t k) const {
  if (!known_any_) return false;
  const int metric_body = scene_.queries[static_cast<std::size_t>(task_.queries.front())].metric.body;
  for (const int body : {task_.pair.a, task_.pair.b, metric_body}) {
    if (body >= 0 && timeline_.moved(body, k) != timeline_.moved(body, known_at_)) return false;
  }
  return true;
}

void InstantRun::look(std::size_t k) {
  if (stands_since(k)) {
    known_.decided = SceneDecision::standing;
    known_.solves = 0;
    known_.seconds = 0;
    return;
  }
  known_ = Known{};
  known_at_ = k;
  known_any_ = true;
  if ((any_distance_ || any_separation_) && (exact_ || !prove_beyond(k))) solve(k);
  solve_growth(k);
}

void InstantRun::hold(std::size_t k, double lower, double rate, bool balls, SceneDecision later) {
  const double budget = (lower - enough_) / (rate * (1 + 1e-12));
  held_until_ = timeline_.last_within(task_.pair, k, budget, balls);
  held_ = true;
  held_decision_ = later;
}

bool InstantRun::prove_beyond(std::size_t k) {
  const auto conclude = [&](SceneDecision decision) {
    known_.beyond = true;
    known_.decided = decision;
    known_.status = SceneStatus::separated;
    return true;
  };
  if (held_ && k <= held_until_) return conclude(held_decision_);
  held_ = false;
  const double ball =
      solver_.ball_bound(timeline_.center(task_.pair.a, k), timeline_.center(task_.pair.b, k));
  if (ball > enough_) {
    hold(k, ball, solver_.ball_rate(), true, SceneDecision::broad_phase);
    return conclude(SceneDecision::broad_phase);
  }
  const bool follows = scene_.queries[static_cast<std::size_t>(task_.queries.front())].metric.body >= 0;
  if (follows || memory_.empty()) return false;
  place(k);
  double rate = 0;
  const double plane = solver_.plane_bound(memory_, rate);
  if (!(plane > enough_)) return false;
  hold(k, plane, rate, false, SceneDecision::coherence);
  return conclude(SceneDecision::coherence);
}

void InstantRun::solve(std::size_t k) {
  place(k);
  const auto begin = std::chrono::steady_clock::now();
  const std::int64_t before = solver_.counters().solves();
  const bool follows = scene_.queries[static_cast<std::size_t>(task_.queries.front())].metric.body >= 0;
  if (any_distance_) {
    const double enough = exact_ ? kInfinity : enough_;
    const PairAnswer& answer = depth_ ? solver_.signed_distance(memory_, enough)
                                      : solver_.distance(memory_, enough, closest_points_, gradient_);
    known_.answer = &answer;
    known_.status = status_of(answer);
    if (!exact_ && answer.lower > enough_) {
      known_.beyond = true;
      if (!follows) hold(k, answer.lower, answer.rate, false, SceneDecision::coherence);
    }
  } else {
    known_.status = status_of(solver_.separation(memory_));
    if (known_.status == SceneStatus::separated) {
      known_.beyond = true;
      double rate = 0;
      const double plane = solver_.plane_bound(memory_, rate);
      if (plane > enough_ && !follows) hold(k, plane, rate, false, SceneDecision::coherence);
    }
  }
  known_.solves = solver_.counters().solves() - before;
  known_.seconds = seconds_since(begin);
  known_.decided = known_.solves > 0 ? SceneDecision::solved : SceneDecision::broad_phase;
}

void InstantRun::solve_growth(std::size_t k) {
  if (!growth_) return;
  bool wanted = false;
  for (const int q : task_.queries) {
    const SceneQuery& query = scene_.queries[static_cast<std::size_t>(q)];
    if (!has_effect(query.effects, SceneEffects::growth)) continue;
    wanted |= !std::isfinite(query.within) || is_within(query);
  }
  if (!wanted) return;
  place(k);
  const auto begin = std::chrono::steady_clock::now();
  const std::int64_t before = solver_.counters().solves();
  known_.growth = &solver_.growth(memory_);
  if (!any_distance_ && !any_separation_) {
    if (known_.growth->lower > 1) known_.status = SceneStatus::separated;
    if (known_.growth->upper < 1) known_.status = SceneStatus::intersecting;
  }
  known_.solves += solver_.counters().solves() - before;
  known_.seconds += seconds_since(begin);
  known_.decided = SceneDecision::solved;
}

bool InstantRun::is_within(const SceneQuery& query) const {
  return !known_.beyond && (known_.answer == nullptr || known_.answer->lower <= query.within);
}

bool InstantRun::is_recorded(const SceneQuery& query, SceneStatus before) const {
  if (std::isfinite(query.within)) return is_within(query);
  const bool only_separated = query.effects == SceneEffects::separated ||
                              !has_effect(query.effects, kDistanceEffects | SceneEffects::growth);
  if (!only_separated || query.every_instant) return true;
  return first_ || known_.status != before;
}

void InstantRun::write(std::size_t k) {
  if (!recording_) return;
  for (std::size_t i = 0; i < task_.queries.size(); ++i) {
    const int q = task_.queries[i];
    const SceneQuery& query = scene_.queries[static_cast<std::size_t>(q)];
    SceneTally& tally = result_.tallies[static_cast<std::size_t>(q)];
    tally.count(known_.decided);
    if (known_.decided == SceneDecision::solved && i > 0) ++tally.shared;
    if (is_recorded(query, status_before_)) write_row(k, q);
  }
}

void InstantRun::write_row(std::size_t k, int q) {
  const SceneQuery& query = scene_.queries[static_cast<std::size_t>(q)];
  SceneRecord row = begin_row(scene_, q, task_.pair, static_cast<std::int64_t>(k));
  row.status = known_.status;
  row.decided = known_.decided;
  row.solves = known_.solves;
  row.seconds = known_.seconds;
  const bool distance = has_effect(query.effects, kDistanceEffects) || std::isfinite(query.within);
  if (distance && !known_.beyond && known_.answer != nullptr) take_asked(*known_.answer, query.effects, row);
  if (has_effect(query.effects, SceneEffects::growth) && known_.growth != nullptr)
    take_growth(*known_.growth, row);
  result_.records.push_back(std::move(row));
}

}  // namespace raygauge
