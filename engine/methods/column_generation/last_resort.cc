// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/last_resort.h"

#include <limits>

#include "engine/methods/column_generation/face_proof.h"
#include "engine/methods/column_generation/plane_proof.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// That exact arithmetic may take for weights that other arithmetic has as good.
constexpr double kSecondsForWeights = 1e-3;

}  // namespace

void LastResort::collect_basis(const SiftingSolve& solve) {
  start_.clear();
  for (int i = 0; i <= solve.sets.n(); ++i) {
    const std::int64_t id = solve.program.basis().view().id[i];
    if (is_artificial(id)) continue;
    start_.push_back(is_from_Q(id) ? id_of_Q(solve.sets.Q().own_index(id / 2))
                                   : id_of_A(solve.sets.A().own_index(id / 2)));
  }
}

ExactSimplex::End LastResort::solve_exactly(const SiftingSolve& solve, double most_seconds) {
  const WorkingSets::Side &A = solve.sets.A(), &Q = solve.sets.Q();
  return exact_.solve({A.set, A.chosen}, {Q.set, Q.chosen}, start_, solve.stopwatch, most_seconds);
}

TwofoldSimplex::End LastResort::solve_twofold(const SiftingSolve& solve) {
  const WorkingSets::Side &A = solve.sets.A(), &Q = solve.sets.Q();
  return twofold_.solve({A.set, A.factor}, {Q.set, Q.factor}, start_, 0.25 * solve.tolerance,
                        solve.sets.kernels(), solve.stopwatch);
}

bool LastResort::certify_twofold(const SiftingSolve& solve) {
  using End = TwofoldSimplex::End;
  collect_basis(solve);
  const End end = solve_twofold(solve);
  solve.sets.counters().points_priced += twofold_.points_priced();
  if (end != End::solved && end != End::unreachable) return false;
  std::int64_t best_A = 0;
  std::int64_t best_Q = 0;
  const double lower = solve.sets.bound_twofold(twofold_.normal(), twofold_.normal_low(), &best_A, &best_Q);
  if (lower == kInfinity) {
    write_answer(solve, DistanceStatus::unreachable, lower, lower);
    return true;
  }
  if (end != End::solved) {
    solve.plane.take(twofold_.normal(), solve.sets.n());
    return solve.plane.certify(solve);
  }
  const double upper = twofold_.basis().upper(solve.stopwatch);
  if (upper > 0 && !solve.closes(lower, upper)) return false;
  write_twofold(solve, lower, upper);
  return true;
}

void LastResort::write_twofold(const SiftingSolve& solve, double lower, double upper) {
  DistanceResult& result = solve.result;
  write_answer(solve, DistanceStatus::optimal, lower, upper);
  if (upper == 0) {
    result.status = DistanceStatus::contains_origin;
    twofold_.basis().weights_of_A(result.origin_weights);
  }
  write_estimate(solve, twofold_.basis().objective());
  if (double* contact = result.room_for_contact(solve.effects, solve.sets.n())) {
    twofold_.basis().contact_point(contact);
    solve.sets.to_own_units(contact);
  }
  result.counters.pivots += twofold_.pivots();
}

ExactSimplex::End LastResort::certify_exactly(const SiftingSolve& solve, double lower) {
  const bool restricted = solve.sets.is_restricted();
  collect_basis(solve);
  const ExactSimplex::End end = solve_exactly(solve, kInfinity);
  if (end == ExactSimplex::End::unreachable && !restricted) {
    write_exact_answer(solve, DistanceStatus::unreachable, {kInfinity, kInfinity, kInfinity}, exact_);
    return ExactSimplex::End::solved;
  }
  if (end != ExactSimplex::End::solved) return end;
  RoundedRatio distance = exact_.distance();
  if (restricted) distance.below = scaled_down(lower, -solve.sets.distance_shift());
  const DistanceStatus status = distance.above == 0 ? DistanceStatus::contains_origin
                                : solve.closes(distance.below, distance.above)
                                    ? DistanceStatus::optimal
                                    : DistanceStatus::precision_limit;
  write_exact_answer(solve, status, distance, exact_);
  return end;
}

void LastResort::round_weights(const SiftingSolve& solve) {
  std::vector<PointWeight>& weights = solve.result.origin_weights;
  start_.clear();
  for (const PointWeight& weight : weights) start_.push_back(id_of_A(weight.index));
  const ExactSimplex::End end = solve_exactly(solve, kSecondsForWeights);
  if (end == ExactSimplex::End::solved && exact_.distance().above == 0) exact_.weights_of_A(weights);
}

void LastResort::write_origin_weights(const SiftingSolve& solve) {
  std::vector<PointWeight>& weights = solve.result.origin_weights;
  if (solve.face.upper(solve) == 0) {
    solve.face.weights(solve, weights);
    if (solve.face.is_rounded()) return;
  } else {
    solve.program.basis().origin_weights(weights);
    for (PointWeight& weight : weights) weight.index = solve.sets.A().own_index(weight.index);
  }
  collect_basis(solve);
  if (solve_exactly(solve, kSecondsForWeights) == ExactSimplex::End::solved && exact_.distance().above == 0) {
    exact_.weights_of_A(weights);
    return;
  }
  if (solve_twofold(solve) == TwofoldSimplex::End::solved && twofold_.basis().upper(solve.stopwatch) == 0)
    twofold_.basis().weights_of_A(weights);
}

}  // namespace raygauge
