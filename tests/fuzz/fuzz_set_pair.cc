// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// The solver on two set files, A and Q, with a line "---" between them: no formula knows the distance, but
// what the three methods prove must not contradict each other, and each lower bound must be that of its
// normal.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "raygauge/queries/solver.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/set_text.h"

namespace raygauge::fuzz::set_pair {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMostDimensions = 6;

/// What rounding may change in h_S(u).
double slack(const ConvexSet& S, const Vector& u) {
  Vector magnitude(S.dimension());
  S.magnitude_unchecked(magnitude.data());
  return 2 * ConvexSet::rounding_error(S.dimension()) * magnitude.dot(u.cwiseAbs());
}

/// lower h_Q(-u) <= -h_A(u), or for an unreachable A h_Q(-u) <= 0 < -h_A(u), up to rounding.
void expect_proof(const DistanceResult& result, const ConvexSet& A, const ConvexSet& Q,
                  const std::string& who) {
  const Vector& u = result.normal;
  if (u.size() == 0 || !u.allFinite() || result.lower == 0) return;
  const double apart = -A.support_function(u), reach = Q.support_function(-u);
  if (result.status == DistanceStatus::unreachable) {
    require(apart >= -slack(A, u) && reach <= slack(Q, u),
            who + "the direction has A and Q on its two sides");
    return;
  }
  const double allowed = slack(A, u) + result.lower * slack(Q, u);
  const double shortfall = result.lower * reach - apart;
  // Beyond the range of doubles nothing is to be seen here.
  if (!std::isfinite(allowed) || !std::isfinite(shortfall)) return;
  require(shortfall <= allowed, who + "the normal proves the lower bound");
}

void expect_status_is_earned(const DistanceResult& result, double tolerance, const std::string& who) {
  require(result.lower >= 0 && result.lower <= result.upper, who + "0 <= lower <= upper");
  if (result.status == DistanceStatus::optimal) {
    require(std::isfinite(result.upper) && result.upper - result.lower <= tolerance * result.upper,
            who + "an optimal result is within the tolerance");
  }
  if (result.status == DistanceStatus::contains_origin)
    require(result.upper == 0, who + "contains_origin has upper = 0");
  if (result.status == DistanceStatus::unreachable)
    require(result.lower == kInfinity, who + "unreachable has lower = +infinity");
}

void check_every_method(const ConvexSet& A, const ConvexSet& Q, double tolerance) {
  double lower = 0, upper = kInfinity;
  for (const auto method :
       {DistanceMethod::newton, DistanceMethod::column_generation, DistanceMethod::zheng_yamane}) {
    DistanceOptions options;
    options.method = method;
    options.tolerance = tolerance;
    options.time_limit = 0.1;
    const std::string who = std::string(to_string(method)) + ": ";
    DistanceSolver solver(options);
    const DistanceResult& result = solver.solve(A, Q, Effects::witness);
    expect_status_is_earned(result, tolerance, who);
    expect_proof(result, A, Q, who);
    lower = std::max(lower, result.lower);
    upper = std::min(upper, result.upper);
    require(lower <= upper, who + "its bounds and those of the methods before it have a number in common");
  }
}

}  // namespace
}  // namespace raygauge::fuzz::set_pair

namespace raygauge::fuzz {

void check_set_pair(std::string_view text) {
  constexpr std::string_view kBetween = "\n---\n";
  const std::size_t between = text.find(kBetween);
  if (between == std::string_view::npos) return;
  expect_success_or_error([&] {
    const cli::SetPointer A = set_of(text.substr(0, between));
    const cli::SetPointer Q = set_of(text.substr(between + kBetween.size()));
    if (A->dimension() != Q->dimension() || A->dimension() > set_pair::kMostDimensions) return;
    for (const double tolerance : {1e-3, 1e-10}) set_pair::check_every_method(*A, *Q, tolerance);
  });
}

}  // namespace raygauge::fuzz
