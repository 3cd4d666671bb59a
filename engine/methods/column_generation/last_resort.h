// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/lp/exact_simplex.h"
#include "engine/lp/twofold_simplex.h"
#include "engine/methods/column_generation/answer.h"

namespace raygauge {

/// The simplex in double-double arithmetic and the exact one, both over all points that may be used, from the
/// last basis of the program.
class LastResort {
 public:
  /// By double-double arithmetic. True where the answer is written; false where the bounds stay apart.
  bool certify_twofold(const SiftingSolve& solve);

  /// By exact arithmetic, with the lower bound that is known for chosen points. ExactSimplex::End::solved
  /// where the answer is written.
  ExactSimplex::End certify_exactly(const SiftingSolve& solve, double lower);

  /// The weights of the basic solution, which is known to combine points of A to the origin, into the result:
  /// rounded as the rational numbers that they are, by the first arithmetic that is certain of it.
  void write_origin_weights(const SiftingSolve& solve);

  /// Weights in the result, of which it is not known how they round: by exact arithmetic, if that takes no
  /// time.
  void round_weights(const SiftingSolve& solve);

 private:
  void collect_basis(const SiftingSolve& solve);
  ExactSimplex::End solve_exactly(const SiftingSolve& solve, double most_seconds);
  TwofoldSimplex::End solve_twofold(const SiftingSolve& solve);
  void write_twofold(const SiftingSolve& solve, double lower, double upper);

  ExactSimplex exact_;
  TwofoldSimplex twofold_;
  std::vector<std::int64_t> start_;  // basic columns, with indices into the sets
};

}  // namespace raygauge
