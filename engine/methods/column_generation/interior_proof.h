// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/lp/common_ray.h"
#include "engine/lp/interior_point.h"
#include "engine/lp/whitened_points.h"
#include "engine/methods/column_generation/answer.h"

namespace raygauge {

/// The interior-point method over the working sets, and what it proves without a basis: where optima are
/// degenerate a simplex stalls.
class InteriorProof {
 public:
  enum class State : std::uint8_t { untried, failed, paused, converged };

  void begin(WorkingSets& sets);

  /// From a guess of the normal, n doubles.
  void run(const SiftingSolve& solve, const double* guess);
  State state() const noexcept { return state_; }

  /// True where the normal that it ended with leaves Q behind, the whole of it: the answer is written.
  bool certify_separated(const SiftingSolve& solve);

  /// Whether what it ended with may prove the answer without a basis, whose inverse takes longer than all its
  /// other proofs. Where its equations have lost their digits, it may have come near a known upper bound.
  bool may_certify(const WorkingSets& sets) const;

  /// By the columns that carry weight, or a plane. Where it has paused and nothing is proven, it goes on.
  /// True where the answer is written.
  bool certify(const SiftingSolve& solve);

  /// The program begins from the columns that carry weight, or from the normal.
  void start(const SiftingSolve& solve);
  void start_at_normal(const SiftingSolve& solve) const;

  /// The lower bound of its normal where that is better than `lower`, the one of the program's normal, which
  /// is the normal at hand otherwise.
  double bound(const SiftingSolve& solve, double lower) const;

  /// A point of A on a ray with one of Q: looked for by run(). write_ray(): the answer with that upper bound.
  CommonRay& ray() noexcept { return ray_; }
  void write_ray(const SiftingSolve& solve, DistanceStatus status, double lower) const;

 private:
  void note(InteriorPoint::End end);
  bool certify_at_hand(const SiftingSolve& solve);
  bool certify_ray(const SiftingSolve& solve);
  bool certify_carriers(const SiftingSolve& solve, double distance);

  InteriorPoint method_;
  WhitenedPoints whitened_;
  CommonRay ray_;
  State state_ = State::untried;
  bool separated_ = false;  // the working sets
  std::vector<InteriorPoint::Carrier> carriers_;
  std::vector<std::int64_t> columns_;
};

}  // namespace raygauge
