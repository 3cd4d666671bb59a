// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/lp/optimal_face.h"
#include "engine/methods/column_generation/answer.h"

namespace raygauge {

/// The proof that no multiple of Q meets A by a plane between them that holds points of Q, so that no other
/// one leaves all of Q behind by a margin. The plane is orthogonal to nearly a direction that is known.
class PlaneProof {
 public:
  void forget() noexcept { direction_.clear(); }
  void take(const double* u, int n) { direction_.assign(u, u + n); }
  bool has_direction() const noexcept { return !direction_.empty(); }

  /// True where the answer is written.
  bool certify(const SiftingSolve& solve);

  /// The same, with the points so `near` the plane, relative to the farthest, taken to lie in it.
  bool certify(const SiftingSolve& solve, double near);

 private:
  double widest_gap(WorkingSets& sets) const;
  std::vector<bool> collect(WorkingSets& sets, const double* u, double near);

  std::vector<double> direction_;  // which may leave Q behind; empty: none
  OptimalFace face_;               // the points in the plane
};

}  // namespace raygauge
