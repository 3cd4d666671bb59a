// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/lp/interior_point.h"
#include "engine/lp/optimal_face.h"
#include "engine/methods/column_generation/answer.h"

namespace raygauge {

/// Upper bounds, 0 among them, from the columns alone that carry weight: at a degenerate optimum the others
/// prove nothing.
class FaceProof {
 public:
  /// From the basic columns of the program; +infinity where nothing is proven.
  double upper(const SiftingSolve& solve);

  /// Whether the basic points of A that carry weight combine to the origin.
  bool proves_zero(const SiftingSolve& solve);

  /// From the columns that the interior-point method leaves weight, where d is about `distance`; those of A
  /// alone where that is 0. True where the answer is written.
  bool certify(const SiftingSolve& solve, double distance, std::span<const double> duals,
               std::span<const InteriorPoint::Carrier> carriers);

  /// The answer by the last upper bound, and the weights of the face.
  void write(const SiftingSolve& solve, double lower, double upper) const;

  /// The points of A with their weights.
  void weights(const SiftingSolve& solve, std::vector<PointWeight>& weights) const;
  bool is_rounded() const noexcept { return face_.is_rounded(); }

 private:
  bool collect_basis(const SiftingSolve& solve, double least, bool with_Q);
  void collect(const SiftingSolve& solve, std::span<const InteriorPoint::Carrier> carriers, bool with_Q);

  OptimalFace face_;
};

}  // namespace raygauge
