// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/axis_points.h"
#include "engine/lp/primal_simplex.h"
#include "engine/methods/column_generation/working_sets.h"
#include "engine/numerics/aligned_buffer.h"

namespace raygauge {

/// A guess of the normal before any solve: from the centre of A towards the origin, as seen where Q is in
/// isotropic position. Exact for homothetic ellipsoids, and never far off in angle for anything round.
class FirstNormal {
 public:
  /// Into sets.direction(), the largest coordinate ±1.
  void guess(WorkingSets& sets);

  /// Starts the program there.
  void start(WorkingSets& sets, PrimalSimplex& program) const;

  /// Whether points of Q stand on all half-axes: a basis to start from.
  bool has_all_axes() const noexcept { return looked_ && axes_.complete(); }

 private:
  bool choose_frame(const WorkingSets& sets);
  void turn(double* v, int n) const;
  static double error(const WorkingSets& sets);

  bool framed_ = false;
  bool looked_ = false;  // for points of Q on the axes
  AxisPoints axes_;
  AlignedBuffer<double> frame_;  // n x n, and its inverse: see FirstGuess
  AlignedBuffer<double> inverse_frame_;
};

}  // namespace raygauge
