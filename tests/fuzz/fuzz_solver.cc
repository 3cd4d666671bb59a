// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The solver on arbitrary doubles: both methods on every instruction set, each result against the distance
// that a rational linear program proves.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "baselines/exact_lp.h"
#include "baselines/exact_verify.h"
#include "raygauge/queries/solver.h"
#include "tests/engine/instruction_sets.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/point_sets_input.h"

namespace raygauge::fuzz::solver {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// lower <= d <= upper in rational arithmetic.
void expect_bounds_hold(const DistanceResult& result, const ExactLpResult& truth, const std::string& who) {
  require(result.lower >= 0 && result.lower <= result.upper, who + "0 <= lower <= upper");
  if (truth.status == DistanceStatus::unreachable) {
    require(result.upper == kInfinity, who + "no finite upper bound where Q never reaches A");
    return;
  }
  require(std::isfinite(result.lower) && Rational(result.lower) <= truth.value, who + "lower <= d");
  require(result.upper == kInfinity || truth.value <= Rational(result.upper), who + "d <= upper");
}

void expect_status_is_earned(const DistanceResult& result, const ExactLpResult& truth, double tolerance,
                             const std::string& who) {
  switch (result.status) {
    case DistanceStatus::optimal:
      require(std::isfinite(result.upper) && result.upper - result.lower <= tolerance * result.upper,
              who + "an optimal result is within the tolerance");
      break;
    case DistanceStatus::contains_origin:
      require(truth.status == DistanceStatus::contains_origin, who + "the origin is in A where it is said");
      require(result.upper == 0, who + "contains_origin has upper = 0");
      break;
    case DistanceStatus::unreachable:
      require(truth.status == DistanceStatus::unreachable, who + "Q never reaches A where it is said");
      require(result.lower == kInfinity, who + "unreachable has lower = +infinity");
      break;
    case DistanceStatus::precision_limit:
    case DistanceStatus::iteration_limit:  // the solver's own guard against stalling
      break;
    case DistanceStatus::time_limit:
      require(false, who + "no time limit was set");
  }
  require(std::isnan(result.distance) || (result.lower <= result.distance && result.distance <= result.upper),
          who + "lower <= distance <= upper");
}

void check_every_solver(const PointSet& A, const PointSet& Q, double tolerance, const ExactLpResult& truth) {
  for (const InstructionSet isa : instruction_sets_here()) {
    for (const DistanceMethod method : {DistanceMethod::column_generation, DistanceMethod::zheng_yamane}) {
      DistanceOptions options;
      options.method = method;
      options.tolerance = tolerance;
      options.instruction_set = isa;
      const std::string who = std::string(to_string(method)) + ", " + std::string(to_string(isa)) + ": ";
      DistanceSolver solver(options);
      const DistanceResult& result = solver.solve(A, Q, Effects::witness);
      expect_bounds_hold(result, truth, who);
      expect_status_is_earned(result, truth, tolerance, who);
      const double lower = result.lower, upper = result.upper;
      const DistanceResult& again = solver.solve(A, Q, Effects::witness);
      require(again.lower == lower && again.upper == upper, who + "a repeated solve gives the same bounds");
    }
  }
}

}  // namespace
}  // namespace raygauge::fuzz::solver

namespace raygauge::fuzz {

void check_solver(std::string_view input) {
  const PointSetsInput instance(input);
  const PointSet A(instance.A()), Q(instance.Q());
  const ExactLpResult truth = solve_exact_lp(A, Q);
  require(verify(A, Q, truth), "the exact linear program proves its answer");
  solver::check_every_solver(A, Q, instance.tolerance(), truth);
}

}  // namespace raygauge::fuzz
