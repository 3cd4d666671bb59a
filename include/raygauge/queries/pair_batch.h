// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"
#include "raygauge/queries/warm_start.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

/// Two bodies in poses. Nothing is copied; sets and poses must outlive the call.
struct PosedPair {
  Posed first, second;
};

/// Output arrays of the caller; entry i is for pair i. Empty arrays are not computed; any other has room for
/// all pairs. Arrays of vectors hold n numbers a pair,
/// NaN where there is no such vector (the bodies meet).
struct BatchAnswers {
  std::span<double> distance;          ///< as in DistanceResult ...
  std::span<double> lower, upper;      ///< ... its certified bounds ...
  std::span<DistanceStatus> status;    ///< ... and how the solve ended
  std::span<double> normal;            ///< DistanceResult::normal
  std::span<double> closest_points_1;  ///< distances alone
  std::span<double> closest_points_2;
};

/// Distances of many pairs of bodies in one call, on OpenMP threads. Every answer is that of
/// ObjectDistanceSolver or GrowthDistanceSolver for the pair alone, whatever the number of threads.
///
/// One batch object per caller; it keeps the solvers of its threads from one call to the next, and a repeated
/// call allocates nothing.
class PairBatch {
 public:
  /// `options.threads` threads share the pairs; each solve stays on one. Throws InvalidParameterError for an
  /// option outside its range.
  explicit PairBatch(const DistanceOptions& options);
  ~PairBatch();
  PairBatch(PairBatch&&) noexcept;
  PairBatch& operator=(PairBatch&&) noexcept;

  /// The distance of each pair in the metric of Q. `warm` is empty, or has one entry a pair that is updated.
  /// Throws DimensionMismatchError where a body does not live in Q's space, and InvalidParameterError for an
  /// array of another size; nothing is solved then.
  void distances(std::span<const PosedPair> pairs, const ConvexSet& Q, const BatchAnswers& answers,
                 std::span<WarmStart> warm = {});

  /// The growth distance of each pair about both centres. All bodies live in one space; throws as above.
  void growth_distances(std::span<const PosedPair> pairs, const BatchAnswers& answers,
                        std::span<WarmStart> warm = {});

 private:
  struct Team;
  std::unique_ptr<Team> team_;
};

}  // namespace raygauge
