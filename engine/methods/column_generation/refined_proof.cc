// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/refined_proof.h"

#include <cmath>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// ‖I - R B‖ from which on the inverse is computed afresh before anything is refined with it.
constexpr double kAccurate = 1e-4;

// Basis changes by refined reduced costs, per row.
constexpr int kRefinedChanges = 2;

}  // namespace

double RefinedProof::lower(const SiftingSolve& solve) {
  Basis& basis = solve.program.basis();
  if (!(basis.residual_share() < kAccurate) && !basis.refactor()) return kInfinity;
  const bool complete = solve.sets.is_complete();
  for (int turn = 0;; ++turn) {
    refined_.refine_duals(basis, solve.sets.kernels());
    std::int64_t best_A = 0;
    std::int64_t best_Q = 0;
    const double lower =
        solve.sets.bound_twofold(solve.program.normal(), refined_.dual_low(), &best_A, &best_Q);
    const double objective = solve.program.objective();
    if (objective - lower <= 0.5 * solve.tolerance * objective) return lower;
    if (!complete || turn == kRefinedChanges * (solve.sets.n() + 1) || solve.stopwatch.expired())
      return lower;
    if (!enter(solve, best_A, best_Q)) return lower;
  }
}

// Of the two columns the one that promises more, over complete working sets.
bool RefinedProof::enter(const SiftingSolve& solve, std::int64_t best_A, std::int64_t best_Q) {
  const int n = solve.sets.n();
  const double t = solve.program.normal()[n];
  const double reduced_A = -((solve.sets.A().h.value + t) + refined_.dual_low()[n]);
  const double reduced_Q = 1 - solve.sets.Q().h.value;
  const bool take_A = reduced_A < reduced_Q * std::fabs(t);
  const double reduced_cost = take_A ? reduced_A : reduced_Q;
  if (!(reduced_cost < 0)) return false;
  return solve.program.enter(take_A ? solve.sets.A().pool : solve.sets.Q().pool, take_A ? best_A : best_Q,
                             reduced_cost);
}

double RefinedProof::upper(const SiftingSolve& solve) {
  Basis& basis = solve.program.basis();
  const double upper = refined_.upper(basis, solve.sets.kernels());
  if (upper < kInfinity) return upper;
  const double gauge = gauge_per_residual(solve);
  return gauge < kInfinity ? refined_.upper_with_residual(basis, solve.sets.kernels(), gauge) : kInfinity;
}

double RefinedProof::upper_despite_residual(const SiftingSolve& solve) {
  const double gauge = gauge_per_residual(solve);
  return gauge < kInfinity ? solve.program.basis().upper_with_residual(gauge) : kInfinity;
}

double RefinedProof::gauge_per_residual(const SiftingSolve& solve) {
  if (gauge_per_residual_ == 0) {
    gauge_per_residual_ =
        gauge_bound_.compute(solve.sets.Q().pool, solve.sets.n(), solve.sets.kernels(), solve.stopwatch);
  }
  return gauge_per_residual_;
}

}  // namespace raygauge
