// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/exact_simplex.h"
#include "engine/lp/primal_simplex.h"
#include "engine/methods/column_generation/working_sets.h"
#include "engine/numerics/stopwatch.h"
#include "raygauge/methods/result.h"

namespace raygauge {

class FaceProof;
class LastResort;
class PlaneProof;

/// What the parts of one solve work on.
struct SiftingSolve {
  WorkingSets& sets;
  PrimalSimplex& program;
  FaceProof& face;
  PlaneProof& plane;
  LastResort& last;
  double tolerance;
  const Stopwatch& stopwatch;
  Effects effects;
  DistanceResult& result;

  /// Whether such bounds answer the question.
  bool closes(double lower, double upper) const noexcept { return Bounds(lower, upper).close(tolerance); }
};

/// Writes bounds on the scaled distance, the normal at hand and what the program knows of the solution.
void write_answer(const SiftingSolve& solve, DistanceStatus status, double lower, double upper);

/// The same of an exact simplex, in the sets' own units.
void write_exact_answer(const SiftingSolve& solve, DistanceStatus status, const RoundedRatio& distance,
                        const ExactSimplex& exact);

/// Another scaled distance than the program's, within the bounds that were written.
void write_estimate(const SiftingSolve& solve, double distance);

}  // namespace raygauge
