// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/answer.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/problem.h"

namespace raygauge {
namespace {

void record_work(const SiftingSolve& solve) {
  DistanceCounters& counters = solve.sets.counters();
  counters.pivots = solve.program.pivots();
  counters.ray_iterations = solve.program.loop().pricings;
  counters.points_priced += solve.program.loop().points_priced;
  counters.refactorisations = solve.program.refactorisations();
  solve.result.counters = counters;
}

}  // namespace

void write_answer(const SiftingSolve& solve, DistanceStatus status, double lower, double upper) {
  WorkingSets& sets = solve.sets;
  DistanceResult& result = solve.result;
  const int n = sets.n(), shift = -sets.distance_shift();
  const Bounds bounds = Bounds(lower, upper).scaled(shift);
  write_bounds(bounds, std::ldexp(solve.program.objective(), shift), status, result);
  // A distance outside the range of doubles has no certificate in them, however narrow the scaled one is.
  if (status == DistanceStatus::optimal && !bounds.close(solve.tolerance))
    result.status = DistanceStatus::precision_limit;

  // u in the sets' own units, with h_Q(-u) = 1.
  const double length = sets.Q().h.value > 0 ? 1.0 / sets.Q().h.value : 1.0;
  const double* v = sets.direction() + n;
  result.normal.resize(n);
  for (int k = 0; k < n; ++k) result.normal[k] = -v[k] * length;

  result.origin_weights.clear();
  if (double* contact = result.room_for_contact(solve.effects, n)) {
    solve.program.basis().contact_point(contact);
    sets.to_own_units(contact);
    ++sets.counters().witness_evaluations;
  }
  record_work(solve);
}

void write_exact_answer(const SiftingSolve& solve, DistanceStatus status, const RoundedRatio& distance,
                        const ExactSimplex& exact) {
  DistanceResult& result = solve.result;
  const int n = solve.sets.n();
  result.status = status;
  result.lower = distance.below;
  result.upper = distance.above;
  result.distance = distance.nearest;
  result.normal.resize(n);
  exact.normal(result.normal.data());
  result.origin_weights.clear();
  if (status == DistanceStatus::contains_origin) exact.weights_of_A(result.origin_weights);
  if (double* contact = result.room_for_contact(solve.effects, n)) {
    exact.contact_point(contact);
    ++solve.sets.counters().witness_evaluations;
  }
  solve.sets.counters().exact_pivots = exact.pivots();
  record_work(solve);
}

void write_estimate(const SiftingSolve& solve, double distance) {
  const double scaled = std::ldexp(distance, -solve.sets.distance_shift());
  solve.result.distance = std::max(solve.result.lower, std::min(scaled, solve.result.upper));
}

}  // namespace raygauge
