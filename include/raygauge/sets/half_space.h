// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {x : n·x <= b}, a half-space of R^m, as of a floor or a wall; in R^2 a half-plane. n is its outer normal,
/// of any length.
///
/// It is the one set that is not bounded: h(u) is infinite for every u that is no multiple of n. Only queries
/// of two objects know it, one of them bounded, in any metric Q and in poses: ObjectDistanceSolver (distance,
/// closest points, gradient, depth), PairBatch::distances, GrowthDistanceSolver::separation, and bodies of
/// scenes. With g = min over K of n·x - b, from one support query of the body K,
///
///     distance = g / h_Q(±n)  for g > 0,      depth = -g / h_Q(∓n)  for g < 0,
///
/// in closed form. Every other use needs a support point or a centre and throws InvalidParameterError: a
/// gauge body, an operand of other sets, a pair of half-spaces. There is no growth distance, because there
/// is no centre to scale it about.
class HalfSpace final : public ConvexSet {
 public:
  /// Throws InvalidParameterError (n = 0; no dimension; b/|n| out of the range of numbers) or NonFiniteError.
  HalfSpace(const ConstVectorRef& normal, double offset);

  /// n and b, both divided by the same power of two, which makes the largest |n_k| a number in [1, 2).
  const Vector& normal() const noexcept { return normal_; }
  double offset() const noexcept { return offset_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;

  Vector normal_;
  double offset_;
};

/// The set as a half-space, or nullptr.
const HalfSpace* as_half_space(const ConvexSet& S) noexcept;

}  // namespace raygauge
