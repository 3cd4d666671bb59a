// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What a solve leaves in its result.
#include <algorithm>
#include <cmath>

#include "engine/methods/column_generation/sifting.h"
#include "engine/methods/problem.h"

namespace raygauge {

void Sifting::finish(DistanceStatus status, double lower, double upper, Effects effects,
                     DistanceResult& result) {
  const int shift = -scaling_.distance_shift();
  const Bounds bounds = Bounds(lower, upper).scaled(shift);
  write_bounds(bounds, std::ldexp(program_.objective(), shift), status, result);
  // A distance outside the range of doubles has no certificate in them, however narrow the scaled one is.
  if (status == DistanceStatus::optimal && !bounds.close(tolerance_))
    result.status = DistanceStatus::precision_limit;

  // u in the sets' own units, with h_Q(-u) = 1.
  const double length = h_Q_.value > 0 ? 1.0 / h_Q_.value : 1.0;
  const double* v = direction_.data() + n_;
  result.normal.resize(n_);
  for (int k = 0; k < n_; ++k) result.normal[k] = -v[k] * length;

  result.origin_weights.clear();
  if (status == DistanceStatus::contains_origin) find_origin_weights(result.origin_weights);
  if (double* contact = result.room_for_contact(effects, n_)) {
    program_.contact_point(contact);
    for (int k = 0; k < n_; ++k) contact[k] /= scaling_.factor_A()[k];
    ++counters_.witness_evaluations;
  }
  record_work(result);
}

// As finish(), in the sets' own units.
void Sifting::finish_exactly(DistanceStatus status, const RoundedRatio& distance, Effects effects,
                             DistanceResult& result) {
  result.status = status;
  result.lower = distance.below;
  result.upper = distance.above;
  result.distance = distance.nearest;
  result.normal.resize(n_);
  exact_.normal(result.normal.data());
  result.origin_weights.clear();
  if (status == DistanceStatus::contains_origin) exact_.weights_of_A(result.origin_weights);
  if (double* contact = result.room_for_contact(effects, n_)) {
    exact_.contact_point(contact);
    ++counters_.witness_evaluations;
  }
  counters_.exact_pivots = exact_.pivots();
  record_work(result);
}

// As finish(), from the basis of the simplex in double-double arithmetic.
void Sifting::finish_with_twofold(double lower, double upper, Effects effects, DistanceResult& result) {
  finish(DistanceStatus::optimal, lower, upper, effects, result);
  if (upper == 0) {
    result.status = DistanceStatus::contains_origin;
    twofold_.weights_of_A(result.origin_weights);
  }
  const double objective = std::ldexp(twofold_.objective(), -scaling_.distance_shift());
  result.distance = std::max(result.lower, std::min(objective, result.upper));
  if (double* contact = result.room_for_contact(effects, n_)) {
    twofold_.contact_point(contact);
    for (int k = 0; k < n_; ++k) contact[k] /= scaling_.factor_A()[k];
  }
  result.counters.pivots += twofold_.pivots();
}

void Sifting::record_work(DistanceResult& result) {
  counters_.pivots = program_.pivots();
  counters_.ray_iterations = program_.pricings();
  counters_.points_priced += program_.points_priced();
  counters_.refactorisations = program_.refactorisations();
  result.counters = counters_;
}

}  // namespace raygauge
