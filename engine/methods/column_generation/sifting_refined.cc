// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The lines of proof in twice the precision: of the basis at hand, and by a simplex in that arithmetic.
#include <algorithm>
#include <cmath>

#include "engine/lp/affords.h"
#include "engine/methods/column_generation/sifting.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// ‖I - R B‖ from which on the inverse is computed afresh before anything is refined with it.
constexpr double kAccurate = 1e-4;

// Basis changes by refined reduced costs, per row.
constexpr int kRefinedChanges = 2;

}  // namespace

// The second line of proof: solution and duals of the basis at hand to some 30 digits. Columns whose reduced
// costs only those digits tell from zero are brought in here. False where the bounds stay apart.
bool Sifting::certify_refined(PrimalSimplex::End end, Effects effects, DistanceResult& result) {
  if (end != PrimalSimplex::End::solved && end != PrimalSimplex::End::failed) return false;
  if (!affords_inverse(*stopwatch_, n_ + 1, *kernels_)) return false;
  Basis& basis = program_.basis();
  if (!(basis.residual_share() < kAccurate) && !basis.refactor()) return false;
  const bool complete = is_complete();
  double lower = 0;
  for (int turn = 0;; ++turn) {
    refined_.refine_duals(basis, *kernels_);
    std::int64_t best_A = 0;
    std::int64_t best_Q = 0;
    lower = refine_lower(program_.normal(), refined_.dual_low(), &best_A, &best_Q);
    const double objective = program_.objective();
    if (objective - lower <= 0.5 * tolerance_ * objective) break;
    if (!complete || turn == kRefinedChanges * (n_ + 1) || stopwatch_->expired()) break;
    if (!enter_refined(best_A, best_Q)) break;
  }
  if (lower == kInfinity) return false;
  double upper = by_face_ ? kInfinity : refined_.upper(basis, *kernels_);
  if (upper == kInfinity && !by_face_ && gauge_per_residual_ == 0) {
    gauge_per_residual_ = gauge_bound_.compute(working_Q_, n_, *kernels_, *stopwatch_);
  }
  if (upper == kInfinity && !by_face_ && gauge_per_residual_ < kInfinity) {
    upper = refined_.upper_with_residual(basis, *kernels_, gauge_per_residual_);
  }
  if (by_face_) upper = upper_of_face();
  if (upper == 0 || !Bounds(lower, upper).close(tolerance_)) return false;  // 0 is another status
  conclude(lower, upper, effects, result);
  return true;
}

// The lower bound that the duals y + y_low prove, and the points that attain h_A(u) and h_Q(-u).
double Sifting::refine_lower(const double* y, const double* y_low, std::int64_t* best_A,
                             std::int64_t* best_Q) {
  direction_low_.reserve(2 * static_cast<std::size_t>(n_));
  double* u = direction_.data();
  double* u_low = direction_low_.data();
  for (int k = 0; k < n_; ++k) {
    u[k] = Scaling::direction_component(scaling_.factor_A()[k], y[k]);
    u[n_ + k] = -Scaling::direction_component(scaling_.factor_Q()[k], y[k]);
    u_low[k] = Scaling::direction_component(scaling_.factor_A()[k], y_low[k]);
    u_low[n_ + k] = -Scaling::direction_component(scaling_.factor_Q()[k], y_low[k]);
  }
  counters_.support_queries += 2;
  counters_.points_priced += A_->size() + Q_->size();
  std::ptrdiff_t index_A = 0;
  std::ptrdiff_t index_Q = 0;
  h_A_ = support_value_twofold(*kernels_, *A_, u, u_low, &index_A);
  h_Q_ = support_value_twofold(*kernels_, *Q_, u + n_, u_low + n_, &index_Q);
  *best_A = id_of_A(index_A);
  *best_Q = id_of_Q(index_Q);
  return lower_bound(h_A_, h_Q_);
}

// Of the two columns the one that promises more, over complete working sets.
bool Sifting::enter_refined(std::int64_t best_A, std::int64_t best_Q) {
  const double t = program_.normal()[n_];
  const double reduced_A = -((h_A_.value + t) + refined_.dual_low()[n_]);
  const double reduced_Q = 1 - h_Q_.value;
  const bool take_A = reduced_A < reduced_Q * std::fabs(t);
  const double reduced_cost = take_A ? reduced_A : reduced_Q;
  if (!(reduced_cost < 0)) return false;
  return program_.enter(take_A ? working_A_ : working_Q_, take_A ? best_A : best_Q, reduced_cost);
}

// The third line of proof: the simplex goes on in double-double arithmetic, with an inverse to match, over
// all points. False where the bounds stay apart.
bool Sifting::certify_twofold(Effects effects, DistanceResult& result) {
  using End = TwofoldSimplex::End;
  collect_basis();
  const End end = twofold_.solve({A_, scaling_.factor_A()}, {Q_, scaling_.factor_Q()}, start_,
                                 0.25 * tolerance_, *kernels_, *stopwatch_);
  counters_.points_priced += twofold_.points_priced();
  if (end != End::solved && end != End::unreachable) return false;
  std::int64_t best_A = 0;
  std::int64_t best_Q = 0;
  const double lower = refine_lower(twofold_.normal(), twofold_.normal_low(), &best_A, &best_Q);
  if (lower == kInfinity) {
    finish(DistanceStatus::unreachable, lower, lower, effects, result);
    return true;
  }
  if (end != End::solved) {
    farkas_.assign(twofold_.normal(), twofold_.normal() + n_);
    return certify_by_plane(effects, result);
  }
  const double upper = twofold_.upper(*stopwatch_);
  if (upper > 0 && !Bounds(lower, upper).close(tolerance_)) return false;
  finish_with_twofold(lower, upper, effects, result);
  return true;
}

}  // namespace raygauge
