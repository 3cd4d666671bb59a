// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "engine/lp/primal_simplex.h"
#include "engine/methods/column_generation/answer.h"
#include "engine/methods/column_generation/face_proof.h"
#include "engine/methods/column_generation/first_normal.h"
#include "engine/methods/column_generation/interior_proof.h"
#include "engine/methods/column_generation/last_resort.h"
#include "engine/methods/column_generation/plane_proof.h"
#include "engine/methods/column_generation/refined_proof.h"
#include "engine/methods/column_generation/working_sets.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/methods/options.h"
#include "raygauge/methods/result.h"

namespace raygauge {

/// The method `column_generation` on a pair of point sets. Small sets are priced whole (PrimalSimplex). Of
/// large ones a sample is solved first; one pass over everything then collects the points that the sample's
/// normal leaves on the wrong side, and the next pass usually proves the answer (Clarkson's sampling;
/// "sifting").
///
/// It starts at a guess (FirstNormal) or, in many dimensions, where an interior-point method ends
/// (InteriorProof). The simplex proves most answers in doubles; the others by more digits of its basis
/// (RefinedProof), by the columns that carry weight (FaceProof), by a plane (PlaneProof), and at last by more
/// digits throughout (LastResort).
class Sifting {
 public:
  void solve(const PointSet& A, const PointSet& Q, const DistanceOptions& options, const Stopwatch& stopwatch,
             Effects effects, DistanceResult& result);

  /// The same over some points only, given by their indices. `upper` is an upper bound on d_Q(A), `lower`
  /// belongs to the chosen points' normal and is a lower bound on d_Q(A) all the same.
  void solve_restricted(const PointSet& A, const PointSet& Q, std::span<const std::int64_t> index_A,
                        std::span<const std::int64_t> index_Q, const DistanceOptions& options,
                        const Stopwatch& stopwatch, DistanceResult& result);

  /// For measuring what proofs cost (bench/safety_cost.cc) and for nothing else: a solve that the simplex
  /// calls solved then ends there, with no bound known.
  void trust_simplex(bool trust) noexcept { trusts_simplex_ = trust; }

 private:
  using End = PrimalSimplex::End;
  enum class Next : std::uint8_t { conclude, again, done };

  void begin(const PointSet& A, const PointSet& Q, const DistanceOptions& options);
  SiftingSolve about(const DistanceOptions& options, const Stopwatch& stopwatch, Effects effects,
                     DistanceResult& result);
  void start(const SiftingSolve& solve);
  void run(const SiftingSolve& solve);
  Next leave_impasse(const SiftingSolve& solve, End end);
  bool finish_inside(const SiftingSolve& solve);
  bool certify_zero(const SiftingSolve& solve);
  bool certify_as_priced(const SiftingSolve& solve);
  bool price_or_separate(const SiftingSolve& solve, End end, double& lower);
  double prove_upper(const SiftingSolve& solve, bool concluded);
  void conclude(const SiftingSolve& solve, double lower, double upper);
  bool certify_refined(const SiftingSolve& solve, End end);
  bool prepare_next(End end, bool points_are_missing);
  void finish_short_of_tolerance(const SiftingSolve& solve, End end, double lower, double upper);
  bool certify_by_last_look(const SiftingSolve& solve);
  bool interior_may_help(End end) const noexcept;
  bool bounds_mislead() noexcept;

  WorkingSets sets_;
  PrimalSimplex program_;
  FirstNormal first_;
  InteriorProof interior_;
  RefinedProof refined_;
  FaceProof face_;
  PlaneProof plane_;
  LastResort last_;

  bool trusts_simplex_ = false;
  bool pivots_are_limited_ = false;     // by the caller
  bool by_face_ = false;                // whether face_ proved the last upper bound
  std::int64_t pivots_at_zero_ = -1;    // when certify_zero() tried last
  std::int64_t pivots_at_repair_ = -1;  // of a basis that is accurate now: its proofs failed
};

}  // namespace raygauge
