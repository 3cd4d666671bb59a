// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_verify.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// Σ w_i p_i, with the sum of weights; `valid` is false where a weight is negative or an index outside the
/// set.
struct Combination {
  std::vector<Rational> point;
  Rational sum = 0;
  bool valid = true;
};

Combination combine(const PointSet& set, const std::vector<ExactWeight>& weights) {
  Combination result{std::vector<Rational>(static_cast<std::size_t>(set.dimension())), 0, true};
  for (const ExactWeight& entry : weights) {
    if (entry.index < 0 || entry.index >= set.size() || entry.weight < 0) {
      result.valid = false;
      return result;
    }
    const Vector p = set.point(entry.index);
    for (int k = 0; k < set.dimension(); ++k) {
      result.point[static_cast<std::size_t>(k)] += entry.weight * Rational(p[k]);
    }
    result.sum += entry.weight;
  }
  return result;
}

/// max over the set of sign·u·p. The denominators of u are cleared first, so that sums are of integers times
/// dyadic numbers.
Rational exact_support(const PointSet& set, const std::vector<Rational>& u, int sign) {
  Integer common = 1;
  for (const Rational& x : u) common = lcm(common, denominator(x));
  std::vector<Rational> cleared;
  cleared.reserve(u.size());
  for (const Rational& x : u) cleared.push_back(x * Rational(sign * common));
  Vector p(set.dimension());
  Rational best = 0;
  for (std::ptrdiff_t i = 0; i < set.size(); ++i) {
    set.copy_point(i, p.data());
    Rational sum = 0;
    for (int k = 0; k < set.dimension(); ++k) sum += cleared[static_cast<std::size_t>(k)] * Rational(p[k]);
    if (i == 0 || sum > best) best = sum;
  }
  return best / Rational(common);
}

bool primal_holds(const PointSet& A, const PointSet& Q, const ExactLpResult& result) {
  const Combination a = combine(A, result.alpha), q = combine(Q, result.beta);
  return a.valid && q.valid && a.sum == 1 && a.point == q.point && q.sum == result.value;
}

bool dual_holds(const PointSet& A, const PointSet& Q, const ExactLpResult& result) {
  return exact_support(A, result.u, 1) <= -result.t && exact_support(Q, result.u, -1) <= 1;
}

bool farkas_holds(const PointSet& A, const PointSet& Q, const ExactLpResult& result) {
  return result.t > 0 && exact_support(A, result.u, 1) <= -result.t && exact_support(Q, result.u, -1) <= 0;
}

/// Whether x < y for a double y that may be +infinity.
bool below(const Rational& x, double y) { return y == kInfinity || x < Rational(y); }

bool rounded_around(const Rational& value, const RoundedDoubles& rounded) {
  if (!std::isfinite(rounded.lower) || Rational(rounded.lower) > value) return false;
  if (Rational(rounded.lower) == value) {
    return rounded.upper == rounded.lower && rounded.nearest == rounded.lower;
  }
  return rounded.upper == std::nextafter(rounded.lower, kInfinity) && below(value, rounded.upper) &&
         (rounded.nearest == rounded.lower || rounded.nearest == rounded.upper);
}

}  // namespace

bool verify(const PointSet& A, const PointSet& Q, const ExactLpResult& result) {
  if (A.dimension() != Q.dimension()) {
    throw DimensionMismatchError("A lives in R^" + std::to_string(A.dimension()) + ", Q in R^" +
                                 std::to_string(Q.dimension()));
  }
  if (result.u.size() != static_cast<std::size_t>(A.dimension())) return false;
  switch (result.status) {
    case DistanceStatus::optimal:
    case DistanceStatus::contains_origin:
      return (result.value == 0) == (result.status == DistanceStatus::contains_origin) &&
             result.t == result.value && primal_holds(A, Q, result) && dual_holds(A, Q, result) &&
             rounded_around(result.value, result.rounded);
    case DistanceStatus::unreachable:
      return result.rounded.lower == kInfinity && result.rounded.upper == kInfinity &&
             farkas_holds(A, Q, result);
    default:
      return false;
  }
}

}  // namespace raygauge
