// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"
#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

class Ladder;

/// What DistanceMethod::automatic stands for: newton where Q is smooth, column_generation otherwise.
DistanceMethod method_for(const ConvexSet& Q) noexcept;

/// Computes the generalized distance of Zheng & Yamane, equation (5),
///
///     d_Q(A) = min{λ >= 0 : A ∩ λQ ≠ ∅},
///
/// with certified bounds lower <= d <= upper. One solver per thread: it owns the workspace, so that a
/// repeated solve of the same size allocates nothing. Every solve is independent of the ones before it,
/// except for the WarmStart that the caller passes.
class DistanceSolver {
 public:
  /// Throws InvalidParameterError for an option outside its range.
  explicit DistanceSolver(const DistanceOptions& options = {});
  ~DistanceSolver();
  DistanceSolver(DistanceSolver&&) noexcept;
  DistanceSolver& operator=(DistanceSolver&&) noexcept;

  const DistanceOptions& options() const noexcept;
  void set_options(const DistanceOptions& options);

  /// Sets a function that the solving thread calls every few milliseconds of a long solve. If it returns
  /// true, the solve ends with time_limit and the bounds known so far. An empty function removes it.
  void set_stop(std::function<bool()> stop);

  /// The distance of A in the gauge of Q. The result belongs to the solver and lives until its next solve;
  /// copy it to keep it. Throws DimensionMismatchError.
  const DistanceResult& solve(const ConvexSet& A, const ConvexSet& Q, Effects effects = Effects::none);

  /// The same for sets in poses, {R x + t : x in A} and Q likewise: solve({A, pose_A}, {Q, pose_Q}). `warm`
  /// is the state that the last solve of this pair stored; this solve updates it. nullptr: a cold start.
  const DistanceResult& solve(const Posed& A, const Posed& Q, Effects effects = Effects::none,
                              WarmStart* warm = nullptr);

 private:
  std::unique_ptr<Ladder> ladder_;
};

}  // namespace raygauge
