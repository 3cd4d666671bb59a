// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "baselines/exact_number.h"
#include "raygauge/methods/result.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// A point's index in its set and its weight in a combination.
struct ExactWeight {
  std::ptrdiff_t index = 0;
  Rational weight;
};

/// The distance between two point sets with its proof, all in rational numbers: see verify().
struct ExactLpResult {
  /// optimal, contains_origin, unreachable, or time_limit (then `rounded` bounds the distance, and the upper
  /// bound is proven by the weights, if there are any).
  DistanceStatus status = DistanceStatus::optimal;

  Rational value;          ///< d_Q(A); 0 for contains_origin, meaningless for unreachable
  RoundedDoubles rounded;  ///< the doubles around it; +infinity for unreachable

  std::vector<ExactWeight> alpha;  ///< on points of A, positive; empty for unreachable
  std::vector<ExactWeight> beta;   ///< on points of Q, positive; empty for unreachable

  /// Dual: u·a <= -t for all of A and -u·q <= 1 for all of Q, with t = value. For unreachable a Farkas
  /// direction: u·a <= -t < 0 for all of A and -u·q <= 0 for all of Q.
  std::vector<Rational> u;
  Rational t;

  /// Basic columns at the end: i for a point i of A, N_A + j for a point j of Q. Fewer than n + 1 where the
  /// columns have lower rank.
  std::vector<std::ptrdiff_t> basis;

  std::int64_t pivots = 0;  ///< exact ones
};

/// Solves the linear program of Example 2 of Zheng & Yamane exactly for the doubles as they are. A simplex in
/// double precision suggests columns. An exact simplex (Bland's rule after a stall) optimises over them, then
/// over all columns: a right suggestion is proven, a wrong one repaired. It ends with a proof unless
/// `time_limit` seconds pass first. Throws DimensionMismatchError.
ExactLpResult solve_exact_lp(const PointSet& A, const PointSet& Q,
                             double time_limit = std::numeric_limits<double>::infinity());

}  // namespace raygauge
