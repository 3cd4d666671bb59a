// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/nearest_run.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/numerics/floating_point.h"
#include "scene/queries/rows.h"

namespace raygauge {
namespace {

struct Candidate {
  std::size_t pair = 0;
  double bound = 0;
};

struct Found {
  std::size_t pair = 0;
  PairAnswer answer;
  double seconds = 0;
  std::int64_t solves = 0;

  friend bool operator<(const Found& x, const Found& y) {
    const double p = x.answer.signed_value(), q = y.answer.signed_value();
    return p != q ? p < q : x.pair < y.pair;
  }
};

class NearestRun {
 public:
  NearestRun(const Scene& scene, const Timeline& timeline, int query, PairSolver& solver,
             SceneCellResult& result)
      : scene_(scene),
        timeline_(timeline),
        number_(query),
        query_(scene.queries[static_cast<std::size_t>(query)]),
        pairs_(pairs_of(scene, query_)),
        memories_(pairs_.size()),
        solver_(solver),
        result_(result) {
    solver_.set_tolerance(query_.tolerance);
  }

  void look(std::size_t k) {
    bound_all(k);
    found_.clear();
    std::int64_t solved = 0;
    std::int64_t coherent = 0;
    for (const Candidate& candidate : candidates_) {
      const double worst = worst_upper();
      if (candidate.bound > worst || candidate.bound > query_.within) break;
      bind(candidate.pair, k);
      if (is_coherently_beyond(candidate.pair, std::min(worst, query_.within))) {
        ++coherent;
        continue;
      }
      solve(candidate.pair);
      ++solved;
    }
    SceneTally& tally = result_.tallies[static_cast<std::size_t>(number_)];
    tally.count(SceneDecision::solved, solved);
    tally.count(SceneDecision::coherence, coherent);
    tally.count(SceneDecision::broad_phase, static_cast<std::int64_t>(pairs_.size()) - solved - coherent);
    for (const Found& found : found_) {
      if (found.answer.lower <= query_.within) write(found, k);
    }
  }

 private:
  void bind_bodies(BodyPair bodies) {
    solver_.bind(scene_.bodies[static_cast<std::size_t>(bodies.a)],
                 scene_.bodies[static_cast<std::size_t>(bodies.b)], query_.metric);
  }

  void bind(std::size_t pair, std::size_t k) {
    const BodyPair bodies = pairs_[pair];
    bind_bodies(bodies);
    Placement metric_at;
    if (query_.metric.body >= 0) metric_at = timeline_.placement(query_.metric.body, k);
    solver_.place(timeline_.placement(bodies.a, k), timeline_.placement(bodies.b, k),
                  query_.metric.body >= 0 ? &metric_at : nullptr);
  }

  void bound_all(std::size_t k) {
    candidates_.clear();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const BodyPair pair = pairs_[i];
      bind_bodies(pair);
      candidates_.push_back(
          {i, solver_.ball_bound(timeline_.center(pair.a, k), timeline_.center(pair.b, k))});
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
      return x.bound != y.bound ? x.bound < y.bound : x.pair < y.pair;
    });
  }

  double worst_upper() const {
    if (found_.size() < static_cast<std::size_t>(query_.nearest)) return kInfinity;
    double worst = 0;
    for (const Found& found : found_) worst = std::max(worst, found.answer.upper);
    return worst;
  }

  bool is_coherently_beyond(std::size_t pair, double limit) {
    if (limit == kInfinity || query_.metric.body >= 0 || memories_[pair].empty()) return false;
    double rate = 0;
    return solver_.plane_bound(memories_[pair], rate) > limit;
  }

  void solve(std::size_t pair) {
    const auto begin = std::chrono::steady_clock::now();
    const std::int64_t before = solver_.counters().solves();
    Found found;
    found.pair = pair;
    PairMemory& memory = memories_[pair];
    found.answer =
        has_effect(query_.effects, SceneEffects::depth)
            ? solver_.signed_distance(memory, kInfinity)
            : solver_.distance(memory, kInfinity, has_effect(query_.effects, SceneEffects::closest_points),
                               has_effect(query_.effects, SceneEffects::gradient));
    found.solves = solver_.counters().solves() - before;
    found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    found_.insert(std::upper_bound(found_.begin(), found_.end(), found), found);
    if (found_.size() > static_cast<std::size_t>(query_.nearest)) found_.pop_back();
  }

  void write(const Found& found, std::size_t k) {
    SceneRecord row = begin_row(scene_, number_, pairs_[found.pair], static_cast<std::int64_t>(k));
    row.status = status_of(found.answer);
    take_asked(found.answer, query_.effects, row);
    row.solves = found.solves;
    row.seconds = found.seconds;
    if (has_effect(query_.effects, SceneEffects::growth)) {
      bind(found.pair, k);
      take_growth(solver_.growth(memories_[found.pair]), row);
    }
    result_.records.push_back(std::move(row));
  }

  const Scene& scene_;
  const Timeline& timeline_;
  int number_;
  const SceneQuery& query_;
  std::vector<BodyPair> pairs_;
  std::vector<PairMemory> memories_;
  PairSolver& solver_;
  SceneCellResult& result_;
  std::vector<Candidate> candidates_;
  std::vector<Found> found_;
};

}  // namespace

void find_nearest(const Scene& scene, const Timeline& timeline, int query, std::size_t first,
                  std::size_t last, PairSolver& solver, SceneCellResult& result,
                  const std::function<bool()>& stop) {
  NearestRun run(scene, timeline, query, solver, result);
  for (std::size_t k = first; k < last && !(stop && stop()); ++k) run.look(k);
}

}  // namespace raygauge
