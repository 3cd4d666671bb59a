// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/zheng_yamane/zheng_yamane.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/zheng_yamane/tuning.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr int kAttemptsToClose = 8;  // outer iterations that pass the published test but leave a gap
constexpr int kPatience = 3;  // outer iterations that do not raise the bound: rounding has the last word
// Where a ray is left for a better bound so often in a row, or with such an η, no multiple of Q may reach A:
// a Farkas direction is to be found.
constexpr int kMostOvertaken = 16;
constexpr double kFarthest = 1e9;       // of sets of magnitude 1
constexpr double kTightestRay = 1e-14;  // below, h_S(u) <= 1 + tolerance is noise

// Rays take tens of iterations, a few hundred at n = 50. One that takes this many goes in circles for
// rounding, and column generation is the faster way out.
std::int64_t default_iteration_limit(int n) { return 500 + 200 * static_cast<std::int64_t>(n); }

}  // namespace

bool ZhengYamane::solve(const Problem& problem, DistanceResult& result) {
  begin(problem);
  const std::int64_t limit =
      options_.max_iterations > 0 ? options_.max_iterations : default_iteration_limit(n_);
  for (;;) {
    is_loose_ = outer_iterations_ == 0 && options_.stop_rule == StopRule::certified_gap &&
                inner_tolerance_ < tuned::kFirstRayTolerance;
    const double tolerance = is_loose_ ? tuned::kFirstRayTolerance : inner_tolerance_;
    const RayShooter::End end = shooter_.shoot(eta_, tolerance, overtaking_bound(), limit, *stopwatch_);
    ++outer_iterations_;
    const Step step = conclude(end);
    if (step == Step::give_up) return false;
    if (step == Step::done) break;
    eta_ = eta_next_;
  }
  finish(problem.effects, result);
  return true;
}

void ZhengYamane::begin(const Problem& problem) {
  const ConvexSet& A = problem.A;
  const ConvexSet& Q = problem.Q;
  options_ = problem.options;
  stopwatch_ = &problem.stopwatch;
  kernels_ = &kernels_for(options_.instruction_set);
  n_ = A.dimension();
  const PointSet* points_A = as_point_set(A);
  const PointSet* points_Q = as_point_set(Q);
  scaled_ = points_A != nullptr && points_Q != nullptr;
  if (scaled_) scaling_.compute(*points_A, *points_Q);
  oracle_A_.bind(A, scaled_ && !scaling_.trivial_A() ? scaling_.factor_A() : nullptr, *kernels_,
                 problem.pairs);
  oracle_Q_.bind(Q, scaled_ && !scaling_.trivial_Q() ? scaling_.factor_Q() : nullptr, *kernels_);
  const auto size = static_cast<std::size_t>(n_);
  center_.reserve(size);
  normal_.reserve(size);
  oracle_A_.center(center_.data());
  shooter_.begin(oracle_A_, oracle_Q_, n_, center_.data(), *kernels_);
  status_ = DistanceStatus::precision_limit;
  eta_ = scaled_ ? std::ldexp(1.0, scaling_.distance_shift()) : 1.0;  // η_0 = 1 in the sets' own units
  inner_tolerance_ = std::max(0.25 * options_.tolerance, kTightestRay);
  bounds_ = {};
  estimate_ = 0;
  outer_iterations_ = 0;
  witness_evaluations_ = 0;
  attempts_to_close_ = 0;
  idle_ = 0;
  overtaken_ = 0;
}

// Rays are not shot to the end where a normal on the way proves a much better bound (10): the next ray
// begins there, from the vertices of this one. The published stop test is about whole rays.
double ZhengYamane::overtaking_bound() const noexcept {
  if (options_.stop_rule == StopRule::published_sigma) return kInfinity;
  if (n_ >= tuned::kManyDimensionsOfRays) return tuned::kOvertakingInMany * eta_;
  return scaled_ ? tuned::kOvertakingInFew * eta_ : kInfinity;
}

ZhengYamane::Step ZhengYamane::conclude(RayShooter::End end) {
  // It takes rounding to reach the default limit.
  const bool endless = end == RayShooter::End::iteration_limit && options_.max_iterations == 0;
  if (end == RayShooter::End::missed || end == RayShooter::End::failed || endless) return Step::give_up;
  sigma_ = shooter_.sigma();
  const double bound_before = bounds_.lower();
  bound_by_normal();
  idle_ = bounds_.lower() > bound_before ? 0 : idle_ + 1;
  if (bounds_.lower() == kInfinity) {
    status_ = DistanceStatus::unreachable;
    bounds_ = {kInfinity, kInfinity};
    return Step::done;
  }
  overtaken_ = end == RayShooter::End::overtaken ? overtaken_ + 1 : 0;
  if (overtaken_ > 0)
    return overtaken_ > kMostOvertaken || eta_next_ > kFarthest ? Step::give_up : Step::go_on;
  if (end != RayShooter::End::hit) {
    status_ =
        end == RayShooter::End::time_limit ? DistanceStatus::time_limit : DistanceStatus::iteration_limit;
    bound_by_vertices();
    return Step::done;
  }
  if (!(eta_next_ > 0)) return Step::give_up;  // h_A(n_k) >= 0: the origin may lie in A
  if (is_loose_ || std::fabs(sigma_ - 1) >= options_.tolerance)
    return idle_ > kPatience ? Step::give_up : Step::go_on;

  bound_by_vertices();
  const bool closed = bounds_.close(options_.tolerance);
  if (closed) status_ = DistanceStatus::optimal;
  if (closed || options_.stop_rule == StopRule::published_sigma) return Step::done;
  // The ray was shot too loosely, or rounding has the last word.
  inner_tolerance_ = std::max(0.1 * inner_tolerance_, kTightestRay);
  return ++attempts_to_close_ > kAttemptsToClose ? Step::give_up : Step::go_on;
}

// Equation (10): the next η is a lower bound, whatever the normal.
void ZhengYamane::bound_by_normal() {
  const SupportValue& h_A = shooter_.set().h_A();
  const SupportValue& h_Q = shooter_.set().h_Q();
  const double bound = lower_bound(h_A, h_Q);
  eta_next_ = h_Q.value > 0 ? -h_A.value / h_Q.value : 0.0;
  if (!bounds_.raise_lower(bound) && outer_iterations_ > 1) return;
  estimate_ = eta_next_;
  const double length = h_Q.value > 0 ? 1.0 / h_Q.value : 1.0;
  for (int k = 0; k < n_; ++k)
    normal_[static_cast<std::size_t>(k)] = Scaling::direction_component(1.0, shooter_.normal()[k]) * length;
}

// The least scale at which the hull of the last vertices of Q meets that of the last vertices of A.
void ZhengYamane::bound_by_vertices() {
  last_vertices_.begin(oracle_A_, oracle_Q_, n_, options_, *kernels_);
  for (int l = 0; l < n_; ++l) {
    const std::int64_t slot = shooter_.vertex(l);
    if (slot < 0) continue;
    last_vertices_.offer_A(shooter_.set().slot_A(slot));
    last_vertices_.offer_Q(shooter_.set().slot_Q(slot));
  }
  if (last_vertices_.offered() == 0) return;
  last_vertices_.solve_offered(normal_.data(), *stopwatch_);
  bounds_.reduce_upper(last_vertices_.bounds().upper());
}

void ZhengYamane::finish(Effects effects, DistanceResult& result) {
  const int shift = scaled_ ? -scaling_.distance_shift() : 0;
  const Bounds bounds = bounds_.scaled(shift);
  write_bounds(bounds, std::ldexp(estimate_, shift), status_, result);
  // A distance outside the range of doubles has no certificate in them, however narrow the scaled one is.
  if (status_ == DistanceStatus::optimal && !bounds.close(options_.tolerance))
    result.status = DistanceStatus::precision_limit;
  result.sigma = sigma_;
  result.normal.resize(n_);
  for (int k = 0; k < n_; ++k) {
    result.normal[k] = normal_[static_cast<std::size_t>(k)] * (scaled_ ? scaling_.factor_Q()[k] : 1.0);
  }
  if (double* contact = result.room_for_contact(effects, n_)) {
    last_vertices_.program().basis().contact_point(contact);
    for (int k = 0; scaled_ && k < n_; ++k) contact[k] /= scaling_.factor_A()[k];
    ++witness_evaluations_;
  }
  result.counters = counters();
}

DistanceCounters ZhengYamane::counters() const {
  DistanceCounters counters;
  counters.outer_iterations = outer_iterations_;
  counters.ray_iterations = shooter_.set().iterations();
  counters.support_queries = 2 * shooter_.set().passes();
  counters.pivots = shooter_.pivots();
  counters.refactorisations = shooter_.refactorisations();
  counters.witness_evaluations = witness_evaluations_;
  return counters;
}

}  // namespace raygauge
