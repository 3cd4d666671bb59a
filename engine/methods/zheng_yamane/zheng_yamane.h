// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/scaling.h"
#include "engine/methods/column_generation/support_column_generation.h"
#include "engine/methods/column_generation/support_oracle.h"
#include "engine/methods/method.h"
#include "engine/methods/zheng_yamane/ray_shooter.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// The method `zheng_yamane`: Algorithm 1 of Zheng & Yamane as published. From η_0 = 1,
///
///     shoot a ray at A - a_c - η_k Q for σ_k and n_k (11)–(16);   stop if |σ_k - 1| < ε;   η_{k+1} =
///     -h_A(n_k)/h_Q(-n_k) (10),
///
/// each ray shooting starting from the vertices of the one before (Fig. 3c). Every η_{k+1} is a lower bound.
/// With StopRule::certified_gap the program over the last vertices (SupportColumnGeneration::solve_offered)
/// adds the upper bound, and the iteration goes on until the gap is closed; the first ray is then shot to a
/// few per cent only, since (10) is a bound for every normal. A ray is then left for the next one as
/// soon as a normal on the way proves a much larger η. Where such a normal leaves Q on the far side,
/// h_Q(-n_k) <= 0, no multiple of Q reaches A.
///
/// It needs what the paper assumes: 0 in the interior of Q, and not in A. Where an iteration shows that this
/// does not hold, a ray fails or goes in circles, or rounding keeps the bound from rising, the solve is not
/// concluded here: solve() returns false and the caller turns to `column_generation`.
class ZhengYamane : public Method {
 public:
  bool solve(const Problem& problem, DistanceResult& result) override;
  DistanceCounters counters() const override;
  void contact_combination(WeightedPoints& combination) const override {
    last_vertices_.program().basis().points_of_A(combination);
  }

 private:
  enum class Step : std::uint8_t { go_on, done, give_up };

  void begin(const Problem& problem);
  double overtaking_bound() const noexcept;
  Step conclude(RayShooter::End end);
  void bound_by_normal();
  void bound_by_vertices();
  void finish(Effects effects, DistanceResult& result);

  DistanceOptions options_;
  const Kernels* kernels_ = nullptr;
  int n_ = 0;
  bool scaled_ = false;
  Scaling scaling_;
  SupportOracle oracle_A_;
  SupportOracle oracle_Q_;
  RayShooter shooter_;
  SupportColumnGeneration last_vertices_;
  const Stopwatch* stopwatch_ = nullptr;
  DistanceStatus status_ = DistanceStatus::precision_limit;
  double eta_ = 1;
  double eta_next_ = 1;
  double inner_tolerance_ = 0;
  bool is_loose_ = false;  // the ray at hand is not shot to that tolerance
  Bounds bounds_;
  double estimate_ = 0;  // the η that the lower one is, rounded down
  double sigma_ = 0;
  std::int64_t outer_iterations_ = 0;
  std::int64_t witness_evaluations_ = 0;
  int attempts_to_close_ = 0;
  int idle_ = 0;
  int overtaken_ = 0;  // rays in a row
  AlignedBuffer<double> center_;
  AlignedBuffer<double> normal_;  // direction of the lower bound, scaled units
};

}  // namespace raygauge
