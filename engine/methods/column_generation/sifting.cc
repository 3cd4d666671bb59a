// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/sifting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/lp/affords.h"
#include "engine/lp/shared_pass.h"
#include "engine/methods/column_generation/simplex_status.h"
#include "engine/methods/problem.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// The points just below the threshold are the next to be violated when the normal turns. Those within this
// fraction of the last pass's violation are taken along: every third solve at n >= 20 is spared a pass by it,
// and the working set hardly grows (measured over 0 … 1).
constexpr double kReach = 0.2;

// Coordinates of both sets up to which a pass costs less than the pivots it may spare.
constexpr std::ptrdiff_t kCheapNumbers = std::ptrdiff_t{1} << 17;

}  // namespace

void Sifting::solve(const PointSet& A, const PointSet& Q, const DistanceOptions& options,
                    const Stopwatch& stopwatch, Effects effects, DistanceResult& result) {
  begin(A, Q, options, stopwatch);
  working_A_.choose(A, scaling_.factor_A(), scaling_.trivial_A(), true);
  working_Q_.choose(Q, scaling_.factor_Q(), scaling_.trivial_Q(), true);
  chosen_A_ = chosen_Q_ = {};
  start();
  if (separated_ && is_separated()) {
    return finish(DistanceStatus::unreachable, kInfinity, kInfinity, effects, result);
  }
  if (may_be_proven_inside()) {
    if (certify_on_the_way(effects, result)) return;
    begin_from_basis();
  }
  run(false, effects, result);
}

void Sifting::solve_restricted(const PointSet& A, const PointSet& Q, std::span<const std::int64_t> index_A,
                               std::span<const std::int64_t> index_Q, const DistanceOptions& options,
                               const Stopwatch& stopwatch, DistanceResult& result) {
  begin(A, Q, options, stopwatch);
  working_A_.clear(n_);
  working_Q_.clear(n_);
  for (const std::int64_t i : index_A) working_A_.add(A, scaling_.factor_A(), i);
  for (const std::int64_t j : index_Q) working_Q_.add(Q, scaling_.factor_Q(), j);
  working_A_.fill_up();
  working_Q_.fill_up();
  chosen_A_ = index_A;
  chosen_Q_ = index_Q;
  start();
  run(true, Effects::none, result);
}

void Sifting::begin(const PointSet& A, const PointSet& Q, const DistanceOptions& options,
                    const Stopwatch& stopwatch) {
  A_ = &A;
  Q_ = &Q;
  n_ = A.dimension();
  tolerance_ = options.tolerance;
  threads_ = options.threads;
  pivots_are_limited_ = options.max_iterations > 0;
  kernels_ = &kernels_for(options.instruction_set);
  stopwatch_ = &stopwatch;
  counters_ = {};
  counters_.outer_iterations = 1;
  gauge_per_residual_ = 0;
  interior_state_ = InteriorState::untried;
  separated_ = false;
  farkas_.clear();
  basis_is_due_ = false;
  ray_.forget();
  pivots_at_zero_ = pivots_at_repair_ = -1;
  violators_A_ = violators_Q_ = {};
  scaling_.compute(A, Q);
  interior_.share_with({team_, threads_});
  program_.basis().share_with({team_, threads_});
  program_.begin(n_, 0.25 * options.tolerance, options.max_iterations, *kernels_, n_ >= kLeastToStall);
  direction_.reserve(2 * static_cast<std::size_t>(n_));
}

// After a solve that ended for no answer: what is done about it.
Sifting::Next Sifting::leave_impasse(PrimalSimplex::End end, bool restricted, Effects effects,
                                     DistanceResult& result) {
  if (interior_may_help(end)) {
    return certify_by_plane(effects, result) || finish_inside(effects, result) ? Next::done : Next::again;
  }
  if (end == PrimalSimplex::End::stalled) {
    program_.be_patient();
    return Next::again;
  }
  if (end != PrimalSimplex::End::bounded || !(is_complete() || restricted || bounds_mislead())) {
    return Next::conclude;
  }
  program_.raise_bounds();
  return Next::again;
}

void Sifting::run(bool restricted, Effects effects, DistanceResult& result) {
  const bool complete = is_complete();
  for (;;) {
    const PrimalSimplex::End end = program_.optimise(working_A_, working_Q_, *stopwatch_);
    if (!restricted && certify_zero(effects, result)) return;
    const Next next = leave_impasse(end, restricted, effects, result);
    if (next == Next::done) return;
    if (next == Next::again) continue;
    const bool solved = end == PrimalSimplex::End::solved;
    const bool trusted = trusts_simplex_ && solved;
    if (trusted && complete) return finish(DistanceStatus::precision_limit, 0, kInfinity, effects, result);
    if (solved && complete && certify_as_priced(effects, result)) return;
    if (solved) program_.refresh_duals();
    const double estimate = program_.objective();
    double lower = 0;
    if (price_or_separate(end, restricted, lower)) continue;
    const bool violated = violators_A_.any || violators_Q_.any;
    if (lower == kInfinity) return finish(DistanceStatus::unreachable, lower, lower, effects, result);
    // Proving the upper bound pays only when the gap can be closed, or nothing else is left to do.
    const bool open = estimate - lower > tolerance_ * estimate;
    if (violated && !is_final(end) && !restricted && open) {
      add_violators();
      continue;
    }
    if (trusted) return finish(DistanceStatus::precision_limit, 0, kInfinity, effects, result);
    const bool out_of_reach = end == PrimalSimplex::End::unreachable || end == PrimalSimplex::End::failed;
    if (out_of_reach && !restricted && certify_by_plane(effects, result)) return;
    const double upper = prove_upper(is_final(end) || restricted || (solved && !violated));
    if (upper == 0 || Bounds(lower, upper).close(tolerance_)) return conclude(lower, upper, effects, result);
    if (!restricted && certify_refined(end, effects, result)) return;
    if (is_final(end) || restricted) return finish_short_of_tolerance(end, lower, upper, effects, result);
    // Where the lower bound is as good as asked for, what still prices out is rounding: the bounds on the
    // normal keep the answer open, not missing points.
    const bool points_are_missing = violated && (open || end != PrimalSimplex::End::bounded);
    const bool again = !points_are_missing && end != PrimalSimplex::End::bounded;
    const bool as_before = again && std::exchange(pivots_at_repair_, program_.pivots()) == program_.pivots();
    if (as_before || !prepare_next(end, points_are_missing))
      return finish_short_of_tolerance(end, lower, upper, effects, result);
  }
}

// `concluded`: there is no better basic solution to come.
double Sifting::prove_upper(bool concluded) {
  by_face_ = false;
  if (!affords_inverse(*stopwatch_, n_ + 1, *kernels_)) return kInfinity;
  double upper = program_.proven_upper();
  if (upper < kInfinity || !concluded) return upper;
  if (n_ >= kLeastToStall) upper = upper_of_face();
  by_face_ = upper < kInfinity;
  return by_face_ ? upper : upper_despite_residual();
}

void Sifting::conclude(double lower, double upper, Effects effects, DistanceResult& result) {
  if (by_face_) return finish_with_face(lower, upper, effects, result);
  if (upper == 0) return finish(DistanceStatus::contains_origin, 0, 0, effects, result);
  finish(DistanceStatus::optimal, lower, upper, effects, result);
}

// The lower bound of the normal at hand. The normal of a program without a solution is tight at a vertex of
// Q: h_Q is zero, but for rounding. True where the program can look for one that separates by a margin
// instead.
bool Sifting::price_or_separate(PrimalSimplex::End end, bool restricted, double& lower) {
  const bool roughly = end == PrimalSimplex::End::unreachable && !restricted;
  lower = price_everything(roughly);
  if (!roughly || lower == kInfinity || violators_A_.any || violators_Q_.any) return false;
  if (farkas_.empty()) farkas_.assign(program_.normal(), program_.normal() + n_);
  if (program_.separate()) return true;
  lower = price_everything(false);
  return false;
}

// What the program's next solve has and the last one had not: points, wider bounds on the normal, a fresh
// inverse. False when nothing is left to try.
bool Sifting::prepare_next(PrimalSimplex::End end, bool points_are_missing) {
  if (points_are_missing) {
    add_violators();
  } else if (end == PrimalSimplex::End::bounded) {
    program_.raise_bounds();
  } else {
    return program_.repair();
  }
  return true;
}

// The simplex loop ends right after a pricing. Of complete sets in place its values bound the distance as
// well as those of one more pass at better duals would, if that is good enough.
bool Sifting::certify_as_priced(Effects effects, DistanceResult& result) {
  if (!scaling_.trivial_A() || !scaling_.trivial_Q()) return false;
  const double* y = program_.normal();
  double* u = direction_.data();
  for (int k = 0; k < n_; ++k) {
    u[k] = y[k];
    u[n_ + k] = -y[k];
  }
  h_A_ = {program_.priced_A(), dot_error(*A_, u)};
  h_Q_ = {program_.priced_Q(), dot_error(*Q_, u)};
  const double resolution = resolution_for(tolerance_);
  if (!well_resolved(h_A_.value, h_A_.error, resolution) ||
      !well_resolved(h_Q_.value, h_Q_.error, resolution)) {
    return false;
  }
  const double lower = lower_bound(h_A_, h_Q_);
  const double upper = program_.proven_upper();
  if (upper == 0 || !Bounds(lower, upper).close(tolerance_)) return false;  // 0 is another status
  counters_.support_queries += 2;
  finish(DistanceStatus::optimal, lower, upper, effects, result);
  return true;
}

// The bounds keep the normal near the guess; where that is good, the first pass finds the right points the
// sooner. Where most bounds are active or a pass has been spent on it, it is not, and raising them over the
// sample costs next to nothing.
bool Sifting::bounds_mislead() const noexcept {
  const bool passes_are_cheap = n_ * (A_->size() + Q_->size()) < kCheapNumbers;
  return !passes_are_cheap && (counters_.support_queries > 0 || 5 * program_.artificials() > 3 * n_);
}

// At a degenerate optimum some weights are zero and cannot be proven nonnegative; and where a limit ended the
// solve artificial columns may still carry weight. What they leave of the equations is paid for.
double Sifting::upper_despite_residual() {
  if (gauge_per_residual_ == 0) {
    gauge_per_residual_ = gauge_bound_.compute(working_Q_, n_, *kernels_, *stopwatch_);
  }
  return gauge_per_residual_ < kInfinity ? program_.upper_with_residual(gauge_per_residual_) : kInfinity;
}

// Rounding (or a default pivot limit, which it takes rounding to reach) keeps the bounds apart. Over chosen
// points the upper bound is all that is asked for.
void Sifting::finish_short_of_tolerance(PrimalSimplex::End end, double lower, double upper, Effects effects,
                                        DistanceResult& result) {
  const bool restricted = !chosen_A_.empty();
  const bool limited = end == PrimalSimplex::End::time_limit ||
                       (end == PrimalSimplex::End::pivot_limit && pivots_are_limited_);
  bool late = false;
  if (!limited && !(restricted && upper < kInfinity)) {
    if (!restricted && certify_twofold(effects, result)) return;
    const ExactSimplex::End exact = finish_by_exact_simplex(lower, effects, result);
    if (exact == ExactSimplex::End::solved) return;
    late = exact == ExactSimplex::End::too_long;
  }
  late = late || stopwatch_->expired();
  if (!restricted) lower = std::max(lower, bound_inside(lower));
  if (n_ >= kLeastToStall && !(upper < kInfinity)) ray_.find(working_A_, working_Q_, n_);
  if (!(std::min(upper, ray_.upper()) < kInfinity) && certify_by_last_look(effects, result)) return;
  if (ray_.upper() < upper)
    return finish_with_ray(late ? DistanceStatus::time_limit : status_of(end), lower, effects, result);
  finish(late ? DistanceStatus::time_limit : status_of(end), lower, upper, effects, result);
}

// The basic columns, with indices into the sets, into start_.
void Sifting::collect_basis() {
  start_.clear();
  for (int i = 0; i <= n_; ++i) {
    const std::int64_t id = program_.basic_ids()[i];
    if (id < 0) continue;
    if (id % 2 == 1) {
      start_.push_back(id_of_Q(working_Q_.index_in(*Q_, scaling_.factor_Q(), id / 2)));
    } else {
      start_.push_back(id_of_A(working_A_.index_in(*A_, scaling_.factor_A(), id / 2)));
    }
  }
}

// End::solved where the result is complete.
ExactSimplex::End Sifting::finish_by_exact_simplex(double lower, Effects effects, DistanceResult& result) {
  const bool restricted = !chosen_A_.empty();
  collect_basis();
  const ExactSimplex::End end = exact_.solve({A_, chosen_A_}, {Q_, chosen_Q_}, start_, *stopwatch_);
  if (end == ExactSimplex::End::unreachable && !restricted) {
    finish_exactly(DistanceStatus::unreachable, {kInfinity, kInfinity, kInfinity}, effects, result);
    return ExactSimplex::End::solved;
  }
  if (end != ExactSimplex::End::solved) return end;
  RoundedRatio distance = exact_.distance();
  if (restricted) distance.below = scaled_down(lower, -scaling_.distance_shift());
  const bool close = Bounds(distance.below, distance.above).close(tolerance_);
  const DistanceStatus status = distance.above == 0 ? DistanceStatus::contains_origin
                                : close             ? DistanceStatus::optimal
                                                    : DistanceStatus::precision_limit;
  finish_exactly(status, distance, effects, result);
  return end;
}

// h_A(u) and h_Q(-u) over the whole sets at the program's normal; of sampled sets also the points that price
// out.
// The lower bound of the program's normal; `roughly`: with no more than the plain bound on rounding errors.
double Sifting::price_everything(bool roughly) {
  const double* y = program_.normal();
  double* u = direction_.data();
  double* v = u + n_;
  for (int k = 0; k < n_; ++k) {
    u[k] = Scaling::direction_component(scaling_.factor_A()[k], y[k]);
    v[k] = -Scaling::direction_component(scaling_.factor_Q()[k], y[k]);
  }
  if (!working_A_.is_complete() || !working_Q_.is_complete()) {
    const std::ptrdiff_t capacity = ColumnPool::growth(*A_);
    const auto both = static_cast<std::size_t>(capacity + ColumnPool::growth(*Q_));
    collected_.reserve(both);
    collected_value_.reserve(both);
    violators_A_.points = {collected_.data(), collected_value_.data(), capacity, 0, kInfinity};
    violators_Q_.points = {collected_.data() + capacity, collected_value_.data() + capacity,
                           ColumnPool::growth(*Q_), 0, kInfinity};
  }
  const double resolution = roughly ? std::numeric_limits<double>::max() : resolution_for(tolerance_);
  h_A_ = price_set(*A_, working_A_, u, program_.threshold_A(), resolution, violators_A_);
  h_Q_ = price_set(*Q_, working_Q_, v, program_.threshold_Q(), resolution, violators_Q_);
  return lower_bound(h_A_, h_Q_);
}

SupportValue Sifting::price_set(const PointSet& S, const ColumnPool& working, const double* direction,
                                double threshold, double resolution, Violators& violators) {
  ++counters_.support_queries;
  counters_.points_priced += S.size();
  if (working.is_complete()) return support_value(*kernels_, S, direction, nullptr, resolution);
  violators.points.threshold = threshold - violators.reach;
  const double value = shared_pass(*kernels_, S, direction, violators.points, threads_, team_);
  violators.any = drop_known(working, S.size(), threshold, violators.points);
  violators.reach = violators.any ? kReach * (value - threshold) : 0;
  const double error = dot_error(S, direction);
  if (well_resolved(value, error, resolution)) return {value, error};
  return support_value(*kernels_, S, direction, nullptr, resolution);
}

// Basic points lie on the threshold, and rounding may put any point of the working set above it. Whether a
// new one is above.
bool Sifting::drop_known(const ColumnPool& working, std::ptrdiff_t size, double threshold,
                         Collection& found) {
  bool any = false;
  std::ptrdiff_t kept = 0;
  for (std::ptrdiff_t i = 0; i < found.count; ++i) {
    const std::int64_t index = std::min<std::int64_t>(found.index[i], size - 1);
    if (working.holds(index)) continue;
    any = any || found.value[i] > threshold;
    found.index[kept] = index;
    found.value[kept++] = found.value[i];
  }
  found.count = kept;
  return any;
}

void Sifting::add_violators() {
  const auto add = [](ColumnPool& working, const PointSet& S, const double* factor,
                      const Collection& violators) {
    for (std::ptrdiff_t i = 0; i < violators.count; ++i) {
      working.add(S, factor, violators.index[i]);
    }
    working.fill_up();
  };
  add(working_A_, *A_, scaling_.factor_A(), violators_A_.points);
  add(working_Q_, *Q_, scaling_.factor_Q(), violators_Q_.points);
  program_.allow_repairs();
}

}  // namespace raygauge
