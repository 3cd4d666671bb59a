// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "raygauge/queries/gradient.h"
#include "raygauge/queries/solver.h"

namespace raygauge {

enum class Separation : std::uint8_t {
  separated,     ///< a plane lies between the objects, proven
  intersecting,  ///< the objects share a point, proven
  undecided,     ///< they touch, or nearly, to within rounding errors; or a limit was reached first
};

/// The answer of a separation test.
struct SeparationResult {
  Separation outcome = Separation::undecided;

  /// For `separated`: u with max u·x over A2 below min u·x over A1. Otherwise empty.
  Vector normal;

  /// Bounds on the growth distance of the two objects about their centres, as far as they were needed.
  double lower = DistanceResult::kUnset;
  double upper = DistanceResult::kUnset;
  DistanceCounters counters;
};

/// Computes the growth distance of Ong & Gilbert, equation (8) of Zheng & Yamane with η_k = 1: A scaled about
/// its centre a_c and Q scaled about the origin touch at
///
///     σ = min{σ >= 0 : (a_c + σ(A - a_c)) ∩ σQ ≠ ∅} = d_B({a_c}),      B = Q - (A - a_c).
///
/// σ > 1 for separated sets, σ < 1 for penetrating ones. One solver per thread; a repeated solve of the same
/// size allocates nothing.
class GrowthDistanceSolver {
 public:
  ~GrowthDistanceSolver();
  GrowthDistanceSolver(GrowthDistanceSolver&&) noexcept;
  GrowthDistanceSolver& operator=(GrowthDistanceSolver&&) noexcept;

  /// `newton` is the default method here: B has second-order information wherever A and Q do. Throws
  /// InvalidParameterError for an option outside its range.
  explicit GrowthDistanceSolver(const DistanceOptions& options = newton_options());

  /// See DistanceSolver::set_stop.
  void set_stop(std::function<bool()> stop);

  /// σ with bounds; 0 and contains_origin where a_c = 0. The result belongs to the solver and lives until its
  /// next solve or test. Throws DimensionMismatchError.
  const DistanceResult& solve(const ConvexSet& A, const ConvexSet& Q);

  /// The same for sets in poses: solve({A, pose_A}, {Q, pose_Q}). `warm` is the state that the last solve of
  /// this pair stored; this solve updates it. nullptr: a cold start. `gradient`, if not nullptr, becomes the
  /// gradient of σ with respect to the twists of Q (body_1) and A (body_2).
  const DistanceResult& solve(const Posed& A, const Posed& Q, WarmStart* warm = nullptr,
                              PoseGradient* gradient = nullptr);

  /// The growth distance of two objects, each scaled about its own centre, that of a posed set being R c + t.
  const DistanceResult& solve_about_centers(const Posed& A1, const Posed& A2, WarmStart* warm = nullptr,
                                            PoseGradient* gradient = nullptr);

  /// Whether two objects are separated: the growth distance about both their centres, stopped at the first
  /// bound that is on one side of 1, and the Euclidean distance where that leaves it open. Objects with
  /// interior points in common are never `undecided` in R^2 and R^3, up to rounding errors of double-double
  /// arithmetic. Throws DimensionMismatchError.
  const SeparationResult& separation(const ConvexSet& A1, const ConvexSet& A2);

  /// The same for objects in poses, with the state that the last test of this pair stored.
  const SeparationResult& separation(const Posed& A1, const Posed& A2, WarmStart* warm = nullptr);

 private:
  static DistanceOptions newton_options();

  std::unique_ptr<Ladder> ladder_;
};

}  // namespace raygauge
