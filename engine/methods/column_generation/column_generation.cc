// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/column_generation.h"

#include <algorithm>
#include <cmath>

namespace raygauge {

bool ColumnGeneration::solve(const Problem& problem, DistanceResult& result) {
  const PointSet* A = as_point_set(problem.A);
  const PointSet* Q = as_point_set(problem.Q);
  are_point_sets_ = A != nullptr && Q != nullptr;
  if (are_point_sets_) {
    sifting_.solve(*A, *Q, problem.options, problem.stopwatch, problem.effects, result);
    counters_ = result.counters;
  } else {
    solve_by_support(problem, result);
  }
  return true;
}

// The tolerances of the linear program suit sets of magnitude 1.
void ColumnGeneration::bind_oracles(const Problem& problem) {
  const Kernels& kernels = kernels_for(problem.options.instruction_set);
  oracle_A_.bind(problem.A, nullptr, kernels, problem.pairs);
  oracle_Q_.bind(problem.Q, nullptr, kernels);
  scaling_.compute_common(problem.A, problem.Q, oracle_A_.magnitude(), oracle_Q_.magnitude());
  if (!scaling_.trivial_A()) oracle_A_.bind(problem.A, scaling_.factor_A(), kernels, problem.pairs);
  if (!scaling_.trivial_Q()) oracle_Q_.bind(problem.Q, scaling_.factor_Q(), kernels);
}

void ColumnGeneration::solve_by_support(const Problem& problem, DistanceResult& result) {
  const int n = problem.A.dimension();
  bind_oracles(problem);
  const int shift = scaling_.distance_shift();
  by_support_.begin(oracle_A_, oracle_Q_, n, problem.options, kernels_for(problem.options.instruction_set),
                    std::ldexp(problem.threshold, shift));
  const DistanceStatus status = by_support_.run(problem.stopwatch);
  write_bounds(by_support_.bounds().scaled(-shift), std::ldexp(by_support_.program().objective(), -shift),
               status, result);
  result.normal = scaling_.factor_Q()[0] * Vector::Map(by_support_.normal(), n);
  counters_ = by_support_.counters();
}

bool ColumnGeneration::report_contact(const Problem& problem, DistanceResult& result) const {
  if (are_point_sets_) return false;
  const int n = problem.A.dimension();
  double* contact = result.room_for_contact(problem.effects, n);
  if (contact == nullptr) return false;
  by_support_.program().basis().contact_point(contact);
  const bool at_origin = result.status == DistanceStatus::contains_origin;
  const double share = at_origin ? 0.0 : 1 / scaling_.factor_A()[0];
  for (int k = 0; k < n; ++k) contact[k] *= share;
  return true;
}

void ColumnGeneration::contact_combination(WeightedPoints& combination) const {
  if (are_point_sets_) return;
  by_support_.program().basis().points_of_A(combination);
  combination.scale(1 / scaling_.factor_A()[0]);
}

}  // namespace raygauge
