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

// The nearest of several parts is that of the least upper bound; of signed distances the deepest, with bounds
// on the depth of all.
void PairSolver::Nearest::take_next(bool is_signed) {
  if (best_->part_a < 0) return std::swap(best_, next_);
  const double lower = std::min(best_->lower, next_->lower);
  const double rate = std::max(best_->rate, next_->rate);
  const double depth_lower = std::fmax(best_->depth_lower, next_->depth_lower);
  const double depth_upper = std::fmax(best_->depth_upper, next_->depth_upper);
  const bool is_less =
      is_signed ? next_->signed_value() < best_->signed_value() : next_->upper < best_->upper;
  if (is_less || (next_->intersecting() && !(is_signed && best_->intersecting()))) std::swap(best_, next_);
  best_->lower = lower;
  best_->rate = rate;
  best_->depth_lower = depth_lower;
  best_->depth_upper = depth_upper;
}

void PairMemory::resize(std::size_t pairs) {
  if (pairs_ == pairs) return;
  pairs_ = pairs;
  solved_.clear();
  all_.resize(is_dense() ? pairs : 0);
}

const PartMemory* PairMemory::find(std::size_t pair) const {
  if (is_dense()) return pair < all_.size() ? &all_[pair] : nullptr;
  const auto found = solved_.find(pair);
  return found == solved_.end() ? nullptr : &found->second;
}

void PairSolver::bind(const Body& a, const Body& b, const SceneMetric& metric) {
  placed_.bind(a, b, metric);
  solver_.forget();
  order_.bind(a, b);
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
  return static_cast<std::size_t>(parts.a) * placed_.b().body().parts.size() +
         static_cast<std::size_t>(parts.b);
}

void PairSolver::take_order(PairMemory& memory) {
  memory.resize(pairs());
  order_.begin(placed_, counters_.ball_tests);
}

// Of two parts, from the plane in memory or their balls.
double PairSolver::plane_bound_of(const PairMemory& memory, const PartCandidate& candidate, double& rate) {
  const PartMemory* kept = memory.find(memory_index(candidate.parts));
  double bound = 0;
  rate = 0;
  if (kept != nullptr && kept->normal.size() > 0) {
    ++counters_.plane_tests;
    bound = placed_.plane_bound(candidate.parts, kept->normal);
    rate = placed_.plane_rate(kept->normal);
  }
  if (pairs() > 1 && candidate.ball_bound > bound) {
    bound = candidate.ball_bound;
    rate = ball_rate();
  }
  return bound;
}

// All pairs after one whose balls are farther apart than the bound are, too.
double PairSolver::plane_bound(const PairMemory& memory, double& rate) {
  double lower = kInfinity;
  rate = 0;
  if (memory.size() != pairs()) return 0;
  order_.begin(placed_, counters_.ball_tests);
  for (const PartCandidate* next = order_.next(); next != nullptr && lower > 0; next = order_.next()) {
    double part_rate = ball_rate();
    const bool is_last = next->ball_bound >= lower;
    if (!is_last) lower = std::min(lower, plane_bound_of(memory, *next, part_rate));
    rate = std::max(rate, part_rate);
    if (is_last) break;
  }
  return lower;
}

// Common points end the search of a distance; parts whose balls meet may overlap deeper than those that were
// solved.
template <class Solve>
PairAnswer& PairSolver::find_nearest(PairMemory& memory, double enough, bool is_signed, const Solve& solve) {
  take_order(memory);
  nearest_.clear();
  double beyond = kInfinity;  // a lower bound of the parts that were not solved
  double beyond_rate = 0;
  for (const PartCandidate* next = order_.next(); next != nullptr; next = order_.next()) {
    const auto [parts, ball_bound] = *next;
    const bool is_known = nearest_.best().part_a >= 0 && (ball_bound > 0 || !is_signed);
    if (is_known && ball_bound >= nearest_.best().upper) break;
    if (ball_bound > enough) {
      beyond = ball_bound;
      beyond_rate = ball_rate();
      break;
    }
    placed_.check_placements();
    solve(parts, memory.of(memory_index(parts)), nearest_.next(parts));
    nearest_.take_next(is_signed);
    if (!is_signed && nearest_.best().intersecting()) break;
  }
  conclude(beyond, beyond_rate);
  return nearest_.best();
}

const PairAnswer& PairSolver::distance(PairMemory& memory, double enough, bool closest_points,
                                       bool gradient) {
  PairAnswer& best =
      find_nearest(memory, enough, false, [&](PartNumbers parts, PartMemory& kept, PairAnswer& answer) {
        solver_.distance(placed_, parts, closest_points, kept, answer, counters_);
      });
  if (gradient && best.normal.size() == placed_.dimension() && best.lower > 0) {
    best.gradient = best.normal;  // body a is moved: A1 of d_Q(A2 - A1)
    ++counters_.gradients;
  }
  return best;
}

const PairAnswer& PairSolver::signed_distance(PairMemory& memory, double enough) {
  return find_nearest(memory, enough, true, [&](PartNumbers parts, PartMemory& kept, PairAnswer& answer) {
    solver_.signed_distance(placed_, parts, kept, answer, counters_);
  });
}

// Parts that were not solved are farther than `beyond`.
void PairSolver::conclude(double beyond, double beyond_rate) {
  PairAnswer& best = nearest_.best();
  if (best.part_a < 0) {
    begin(best, -1, -1);
    best.lower = beyond;
  } else {
    best.lower = std::min(best.lower, beyond);
    best.value = std::clamp(best.value, best.lower, best.upper);
  }
  best.rate = std::max(best.rate, beyond_rate);
}

Separation PairSolver::separation(PairMemory& memory) {
  take_order(memory);
  Separation outcome = Separation::separated;
  for (const PartCandidate* next = order_.next(); next != nullptr; next = order_.next()) {
    const auto [parts, ball_bound] = *next;
    if (ball_bound > 0) break;
    PartMemory& kept = memory.of(memory_index(parts));
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
  take_order(memory);
  placed_.check_placements();
  least_growth_.clear();
  for (const PartCandidate* next = order_.next(); next != nullptr; next = order_.next()) {
    const auto [parts, ball_bound] = *next;
    solver_.growth(placed_, parts, memory.of(memory_index(parts)), least_growth_.next(parts), counters_);
    least_growth_.take_next(false);
  }
  PairAnswer& best = least_growth_.best();
  best.value = std::clamp(best.value, best.lower, best.upper);
  return best;
}

}  // namespace raygauge
