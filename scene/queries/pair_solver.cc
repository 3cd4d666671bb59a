// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/queries/pair_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// As a new one, of parts a and b.
void begin(PairAnswer& answer, int a, int b) noexcept {
  answer.lower = answer.value = answer.rate = 0;
  answer.upper = kInfinity;
  answer.depth_lower = answer.depth_upper = SceneRecord::kNone;
  answer.status = DistanceStatus::optimal;
  answer.part_a = a;
  answer.part_b = b;
  for (SmallVector* vector : {&answer.normal, &answer.point_a, &answer.point_b, &answer.gradient})
    vector->resize(0);
}

}  // namespace

PairAnswer& PairSolver::Nearest::next(PartNumbers parts) noexcept {
  begin(*next_, parts.a, parts.b);
  return *next_;
}

// The nearest of several parts is that of the least upper bound; common points end the search.
void PairSolver::Nearest::take_next() {
  if (best_->part_a < 0) return std::swap(best_, next_);
  const double lower = std::min(best_->lower, next_->lower);
  const double rate = std::max(best_->rate, next_->rate);
  if (next_->upper < best_->upper || next_->intersecting()) std::swap(best_, next_);
  best_->lower = lower;
  best_->rate = rate;
}

// The same of signed distances: the deepest, with bounds on the depth of all.
void PairSolver::Nearest::take_deeper() {
  if (best_->part_a < 0) return std::swap(best_, next_);
  const double lower = std::min(best_->lower, next_->lower);
  const double rate = std::max(best_->rate, next_->rate);
  const double depth_lower = std::fmax(best_->depth_lower, next_->depth_lower);
  const double depth_upper = std::fmax(best_->depth_upper, next_->depth_upper);
  if (next_->signed_value() < best_->signed_value() || (next_->intersecting() && !best_->intersecting())) {
    std::swap(best_, next_);
  }
  best_->lower = lower;
  best_->rate = rate;
  best_->depth_lower = depth_lower;
  best_->depth_upper = depth_upper;
}

void PairSolver::bind(const Body& a, const Body& b, const SceneMetric& metric) {
  placed_.bind(a, b, metric);
  solver_.forget();
  candidates_.clear();
  for (int i = 0; i < static_cast<int>(a.parts.size()); ++i) {
    for (int j = 0; j < static_cast<int>(b.parts.size()); ++j) candidates_.push_back({{i, j}, 0});
  }
}

double PairSolver::ball_bound(const double* center_a, const double* center_b) {
  ++counters_.ball_tests;
  return placed_.ball_bound(center_a, center_b);
}

double PairSolver::apart_along(const SmallVector& u, SmallVector& arm_a, SmallVector& arm_b) {
  ++counters_.plane_tests;
  return placed_.apart_along(u, arm_a, arm_b);
}

std::size_t PairSolver::memory_index(PartNumbers parts) const {
  return static_cast<std::size_t>(parts.a) * placed_.b().parts.size() + static_cast<std::size_t>(parts.b);
}

void PairSolver::sort_candidates() {
  if (candidates_.size() == 1) {
    candidates_.front().ball_bound = 0;
    return;
  }
  for (Candidate& candidate : candidates_) {
    candidate.ball_bound = placed_.part_ball_bound(candidate.parts);
    ++counters_.ball_tests;
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
    if (x.ball_bound != y.ball_bound) return x.ball_bound < y.ball_bound;
    return x.parts.a != y.parts.a ? x.parts.a < y.parts.a : x.parts.b < y.parts.b;
  });
}

double PairSolver::plane_bound(const PairMemory& memory, double& rate) {
  double lower = kInfinity;
  rate = 0;
  if (memory.size() != candidates_.size()) return 0;
  for (const Candidate& candidate : candidates_) {
    const SmallVector& u = memory[memory_index(candidate.parts)].normal;
    double bound = 0, part_rate = 0;
    if (u.size() > 0) {
      ++counters_.plane_tests;
      bound = placed_.plane_bound(candidate.parts, u);
      part_rate = placed_.plane_rate(u);
    }
    if (candidates_.size() > 1) {
      ++counters_.ball_tests;
      const double ball = placed_.part_ball_bound(candidate.parts);
      if (ball > bound) {
        bound = ball;
        part_rate = ball_rate();
      }
    }
    if (!(bound > 0)) return 0;
    lower = std::min(lower, bound);
    rate = std::max(rate, part_rate);
  }
  return lower;
}

const PairAnswer& PairSolver::distance(PairMemory& memory, double enough, bool closest_points,
                                       bool gradient) {
  memory.resize(candidates_.size());
  sort_candidates();
  nearest_.clear();
  double beyond = kInfinity;  // a lower bound of the parts that were not solved
  double beyond_rate = 0;
  for (const auto& [parts, ball_bound] : candidates_) {
    if (nearest_.best().part_a >= 0 && ball_bound >= nearest_.best().upper) break;
    if (ball_bound > enough) {
      beyond = ball_bound;
      beyond_rate = ball_rate();
      break;
    }
    placed_.check_placements();
    solver_.distance(placed_, parts, closest_points, memory[memory_index(parts)], nearest_.next(parts),
                     counters_);
    nearest_.take_next();
    if (nearest_.best().intersecting()) break;
  }
  conclude(beyond, beyond_rate);
  PairAnswer& best = nearest_.best();
  if (gradient && best.normal.size() == placed_.dimension() && best.lower > 0) {
    best.gradient = best.normal;  // body a is moved: A1 of d_Q(A2 - A1)
    ++counters_.gradients;
  }
  return best;
}

// Parts that were not solved are farther than `beyond`.
const PairAnswer& PairSolver::conclude(double beyond, double beyond_rate) {
  PairAnswer& best = nearest_.best();
  if (best.part_a < 0) {
    begin(best, -1, -1);
    best.lower = beyond;
  } else {
    best.lower = std::min(best.lower, beyond);
    best.value = std::clamp(best.value, best.lower, best.upper);
  }
  best.rate = std::max(best.rate, beyond_rate);
  return best;
}

// Parts whose balls meet may overlap deeper than those that were solved.
const PairAnswer& PairSolver::signed_distance(PairMemory& memory, double enough) {
  memory.resize(candidates_.size());
  sort_candidates();
  nearest_.clear();
  double beyond = kInfinity, beyond_rate = 0;
  for (const auto& [parts, ball_bound] : candidates_) {
    const bool solved = nearest_.best().part_a >= 0;
    if (solved && ball_bound > 0 && ball_bound >= nearest_.best().upper) break;
    if (ball_bound > enough) {
      beyond = ball_bound;
      beyond_rate = ball_rate();
      break;
    }
    placed_.check_placements();
    solver_.signed_distance(placed_, parts, memory[memory_index(parts)], nearest_.next(parts), counters_);
    nearest_.take_deeper();
  }
  return conclude(beyond, beyond_rate);
}

Separation PairSolver::separation(PairMemory& memory) {
  memory.resize(candidates_.size());
  sort_candidates();
  Separation outcome = Separation::separated;
  for (const auto& [parts, ball_bound] : candidates_) {
    if (ball_bound > 0) break;
    PartMemory& kept = memory[memory_index(parts)];
    if (kept.normal.size() > 0) {
      ++counters_.plane_tests;
      if (placed_.plane_bound(parts, kept.normal) > 0) continue;
    }
    placed_.check_placements();
    const Separation found = solver_.separation(placed_, parts, kept, counters_);
    if (found == Separation::intersecting) return Separation::intersecting;
    if (found == Separation::undecided) outcome = Separation::undecided;
  }
  return outcome;
}

const PairAnswer& PairSolver::growth(PairMemory& memory) {
  memory.resize(candidates_.size());
  sort_candidates();
  placed_.check_placements();
  least_growth_.clear();
  for (const auto& [parts, ball_bound] : candidates_) {
    solver_.growth(placed_, parts, memory[memory_index(parts)], least_growth_.next(parts), counters_);
    least_growth_.take_next();
  }
  PairAnswer& best = least_growth_.best();
  best.value = std::clamp(best.value, best.lower, best.upper);
  return best;
}

}  // namespace raygauge
