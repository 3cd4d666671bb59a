// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/support_column_generation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/lp/scaling.h"
#include "engine/methods/column_generation/simplex_status.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kGuessError = 0.25;  // of the first normal, relative

// Points of Q per dimension that are tried, beyond those along the axes, to surround the origin.
constexpr int kSurroundingPoints = 2;

// Rounds without a better bound after which rounding has the last word.
int patience(int n) { return 16 + 4 * n; }

// Along a direction so long that its products overflow, sets answer with what is no point.
bool is_point(const double* x, int n) {
  return std::all_of(x, x + n, [](double coordinate) { return std::isfinite(coordinate); });
}

}  // namespace

void SupportColumnGeneration::begin(SupportOracle& A, SupportOracle& Q, int n, const DistanceOptions& options,
                                    const Kernels& kernels, double threshold) {
  A_ = &A;
  Q_ = &Q;
  n_ = n;
  goal_ = {options.tolerance, threshold};
  lower_ = 0;
  upper_ = kInfinity;
  counters_ = {};
  counters_.outer_iterations = 1;
  points_A_.clear(n);
  points_Q_.clear(n);
  gauge_per_residual_ = 0;
  moved_upper_ = kInfinity;
  const auto size = static_cast<std::size_t>(n);
  point_A_.reserve(size);
  point_Q_.reserve(size);
  normal_.reserve(size);
  axis_.reserve(2 * size);
  kernels_ = &kernels;
  program_.begin(n, 0.125 * options.tolerance, options.max_iterations, kernels);
}

// One support query of each set at u, and the lower bound that comes with it.
void SupportColumnGeneration::ask(const double* u) {
  h_A_ = A_->verify(u, 1.0, -kInfinity, point_A_.data());
  h_Q_ = Q_->verify(u, -1.0, -kInfinity, point_Q_.data());
  counters_.support_queries += 2;
  ++counters_.ray_iterations;
  const double bound = lower_bound(h_A_, h_Q_);
  if (bound > lower_ || counters_.support_queries == 2) {
    lower_ = bound;
    const double length = h_Q_.value > 0 ? 1.0 / h_Q_.value : 1.0;
    // The direction that the sets were asked along, to which the smallest components do not belong.
    for (int k = 0; k < n_; ++k)
      normal_[static_cast<std::size_t>(k)] = Scaling::direction_component(1.0, u[k]) * length;
  }
}

// At a degenerate optimum some weights are zero and cannot be proven nonnegative: what that leaves of the
// equations is paid for. The support points along the axes make sure that the known part of Q surrounds the
// origin if Q does.
double SupportColumnGeneration::gauge_per_residual(const Stopwatch& stopwatch) {
  if (gauge_per_residual_ > 0) return gauge_per_residual_;
  gauge_per_residual_ = surround_origin(*Q_, points_Q_, stopwatch);
  return gauge_per_residual_;
}

// G with gauge_S(r) <= G |r|∞ for the known points of S, to which as many are added as it takes; +infinity
// where the origin is not proven to be in the interior.
double SupportColumnGeneration::surround_origin(SupportOracle& S, ColumnPool& points,
                                                const Stopwatch& stopwatch) {
  // |r| <= √n |r|∞, and a ball around the origin of which the set itself knows makes the search unnecessary.
  const double radius = S.inner_radius();
  if (radius > 0) return std::sqrt(n_) / radius * (1 + 4 * std::numeric_limits<double>::epsilon());
  double* axis = axis_.data();
  double* point = axis + n_;
  std::fill_n(axis, n_, 0.0);
  for (int k = 0; k < 2 * n_; ++k) {
    if (stopwatch.expired()) return kInfinity;
    axis[k / 2] = 1.0;
    S.query(axis, k % 2 == 0 ? 1.0 : -1.0, point);
    axis[k / 2] = 0.0;
    points.add(point);
  }
  counters_.support_queries += std::int64_t{2} * n_;
  double gauge = gauge_bound_.compute(points, n_, *kernels_, stopwatch);
  // Ties can leave the origin outside the hull of those points (a box answers with corners of its own
  // choice).
  for (int more = 0; more < kSurroundingPoints * n_ && gauge == kInfinity && !stopwatch.expired(); ++more) {
    S.query(gauge_bound_.normal(), -1.0, point);
    points.add(point);
    ++counters_.support_queries;
    gauge = gauge_bound_.compute(points, n_, *kernels_, stopwatch);
  }
  return gauge;
}

// The origin is a combination of the points of A as computed. That proves 0 in A where A has them exactly;
// otherwise a neighbourhood of the origin must be in their hull, larger than what rounding moved them by.
bool SupportColumnGeneration::holds_origin(const Stopwatch& stopwatch) {
  const double error = A_->coordinate_error();
  return error == 0 || surround_origin(*A_, points_A_, stopwatch) * error < 0.5;
}

double SupportColumnGeneration::upper_despite_residual(const Stopwatch& stopwatch) {
  const double gauge = gauge_per_residual(stopwatch);
  return gauge < kInfinity ? program_.basis().upper_with_residual(gauge) : kInfinity;
}

// Σβ is proven for the support points as computed. Those of A and Q themselves lie within e_A and e_Q of
// them, in any coordinate; with them the equations keep a residual |r|∞ <= e_A + Σβ e_Q, which costs G |r|∞.
// G is known for the computed points of Q: for Q itself it is G / (1 - G e_Q). Where the origin is not in the
// interior there is no G; weights well above zero stay so when the points move.
double SupportColumnGeneration::upper_of_the_sets(double upper_of_the_points, const Stopwatch& stopwatch) {
  const double error_A = A_->coordinate_error();
  const double error_Q = Q_->coordinate_error();
  if (!(upper_of_the_points < kInfinity) || (error_A == 0 && error_Q == 0)) return upper_of_the_points;
  const double gauge = gauge_per_residual(stopwatch);
  const double left = 1 - gauge * error_Q;
  if (!(gauge < kInfinity) || !(left > 0.5)) {
    moved_upper_ = std::min(moved_upper_, program_.upper_of_moved_points(error_A, error_Q));
    return moved_upper_;
  }
  constexpr double kRoundedUp = 1 + 16 * std::numeric_limits<double>::epsilon();
  return (upper_of_the_points + gauge / left * (error_A + upper_of_the_points * error_Q)) * kRoundedUp;
}

DistanceStatus SupportColumnGeneration::run(const Stopwatch& stopwatch) {
  const DistanceStatus status = iterate(stopwatch);
  if (status != DistanceStatus::contains_origin) upper_ = upper_of_the_sets(upper_, stopwatch);
  const bool unfinished =
      status == DistanceStatus::precision_limit || status == DistanceStatus::iteration_limit;
  return unfinished && closes_by_gauge() ? DistanceStatus::optimal : status;
}

// Where Q has a formula for its gauge, that of any point x of A is an upper bound, and its normal there a
// direction to ask: both are good even where support points crowd so much that their combinations say little.
bool SupportColumnGeneration::closes_by_gauge() {
  contact_.clear(n_);
  program_.basis().points_of_A(contact_);
  double* x = axis_.data();
  if (contact_.average(x)) ask_gauge(x);
  std::copy_n(point_A_.data(), n_, x);
  ask_gauge(x);
  return bounds().reach(goal_);
}

// x is a combination of computed points of A.
void SupportColumnGeneration::ask_gauge(const double* x) {
  double* normal = axis_.data() + n_;
  const double gauge = Q_->gauge(x, normal);
  if (!(gauge < kInfinity)) return;
  for (int k = 0; k < n_; ++k) normal[k] = -normal[k];
  ask(normal);
  upper_ = std::min(upper_, (gauge + gauge_of_rounding()) * (1 + 4 * std::numeric_limits<double>::epsilon()));
}

// What is off by at most e_k in coordinate k has a gauge of at most Σ e_k max gauge(±e_k), e_k the k-th unit
// vector: that of a combination of points of A.
double SupportColumnGeneration::gauge_of_rounding() {
  double* axis = point_Q_.data();
  double* normal = axis_.data() + n_;
  double sum = 0;
  std::fill_n(axis, n_, 0.0);
  for (int k = 0; k < n_; ++k) {
    double most = 0;
    for (const double sign : {1.0, -1.0}) {
      axis[k] = sign;
      most = std::max(most, Q_->gauge(axis, normal));
    }
    axis[k] = 0;
    const double of_combination = (n_ + 8) * std::numeric_limits<double>::epsilon() * A_->magnitude(k);
    sum += (A_->coordinate_error(k) + of_combination + kUnderflow) * most;
  }
  return sum;
}

// The first normal: from the centre of A towards the origin, with the support points along it.
void SupportColumnGeneration::start() {
  double* guess = normal_.data();
  A_->center(guess);
  bool zero = true;
  for (int k = 0; k < n_; ++k) {
    guess[k] = -guess[k];
    zero = zero && guess[k] == 0;
  }
  if (zero) guess[0] = 1.0;
  ask(guess);
  offer_A(point_A_.data());
  offer_Q(point_Q_.data());
  program_.start(points_A_, points_Q_, {guess, kGuessError});
}

// Works with the support points as computed: upper_ is theirs until run() pays for the difference.
DistanceStatus SupportColumnGeneration::iterate(const Stopwatch& stopwatch) {
  start();
  if (A_->inner_radius() > 0) {
    lower_ = upper_ = 0;
    return DistanceStatus::contains_origin;
  }
  Best best;
  bool offered = false;
  std::int64_t pivots = 0;
  for (;;) {
    const PrimalSimplex::End end = program_.solve(points_A_, points_Q_, stopwatch);
    // New points that change nothing, their reduced costs being rounding, would only be met again.
    const bool stuck = offered && program_.pivots() == pivots;
    pivots = program_.pivots();
    ask(program_.normal());
    if (lower_ == kInfinity) return DistanceStatus::unreachable;
    take_upper_bound(end, stopwatch);
    if (upper_ == 0) {
      return holds_origin(stopwatch) ? DistanceStatus::contains_origin : DistanceStatus::precision_limit;
    }
    if (bounds().reach(goal_) && Bounds(lower_, upper_of_the_sets(upper_, stopwatch)).reach(goal_))
      return DistanceStatus::optimal;
    if (is_final(end)) return status_of(end);
    if (note_progress(end, best) > patience(n_)) return DistanceStatus::precision_limit;
    offered = !stuck && offer_support_points();
    if (offered) continue;
    if (end == PrimalSimplex::End::unreachable && program_.separate()) {
      best = {};  // of another objective
    } else if (!prepare_next(end)) {
      return DistanceStatus::precision_limit;
    }
  }
}

// Of the program's last solution. What an earlier one proved says nothing of this one's residual.
void SupportColumnGeneration::take_upper_bound(PrimalSimplex::End end, const Stopwatch& stopwatch) {
  if (end != PrimalSimplex::End::bounded) upper_ = std::min(upper_, program_.proven_upper());
  const bool proven = upper_ < kInfinity && upper_ - program_.objective() <= goal_.tolerance * upper_;
  if (!proven && end == PrimalSimplex::End::solved) {
    upper_ = std::min(upper_, upper_despite_residual(stopwatch));
  }
}

// The number of rounds since the last one that made something better. An objective under bounds on the normal
// is no value to compare with.
int SupportColumnGeneration::note_progress(PrimalSimplex::End end, Best& best) const {
  const double objective = program_.objective();
  const bool better = lower_ > best.lower || upper_ < best.upper || objective < best.objective;
  best.idle_rounds = better ? 0 : best.idle_rounds + 1;
  best.lower = std::max(best.lower, lower_);
  best.upper = std::min(best.upper, upper_);
  best.objective = end == PrimalSimplex::End::bounded ? kInfinity : std::min(best.objective, objective);
  return best.idle_rounds;
}

// Makes those of the last support points known that price out; false if neither does.
bool SupportColumnGeneration::offer_support_points() {
  const PrimalSimplex::Thresholds above = program_.thresholds();
  const bool A_enters = h_A_.value > above.A && is_point(point_A_.data(), n_);
  const bool Q_enters = h_Q_.value > above.Q && is_point(point_Q_.data(), n_);
  if (A_enters) offer_A(point_A_.data());
  if (Q_enters) offer_Q(point_Q_.data());
  if (!A_enters && !Q_enters) return false;
  program_.allow_repairs();
  return true;
}

// Without new points: wider bounds on the normal, or a fresh inverse. False when nothing is left to try.
bool SupportColumnGeneration::prepare_next(PrimalSimplex::End end) {
  if (end != PrimalSimplex::End::bounded) return program_.repair();
  program_.raise_bounds();
  return true;
}

void SupportColumnGeneration::solve_offered(const double* guess, const Stopwatch& stopwatch) {
  program_.start(points_A_, points_Q_, {guess, kGuessError});
  PrimalSimplex::End end = program_.solve(points_A_, points_Q_, stopwatch);
  while (end == PrimalSimplex::End::bounded) {
    program_.raise_bounds();
    end = program_.solve(points_A_, points_Q_, stopwatch);
  }
  if (end != PrimalSimplex::End::solved) return;
  upper_ = std::min(upper_, upper_of_the_sets(program_.proven_upper(), stopwatch));
}

const DistanceCounters& SupportColumnGeneration::counters() {
  counters_.pivots = program_.pivots();
  counters_.points_priced = program_.loop().points_priced;
  counters_.refactorisations = program_.refactorisations();
  return counters_;
}

}  // namespace raygauge
