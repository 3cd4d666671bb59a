// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/kernels/kernel.h"
#include "engine/lp/column_pool.h"
#include "engine/lp/primal_simplex.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// Coordinate k of a point in general position to most structured sets: in [1/2, 1) of either sign, and no
/// linear relation of small integers holds between them.
double generic_coordinate(int k);

/// A proven bound on the gauge of a small vector: G with
///
///     gauge_Q(r) <= G |r|∞   for every r,
///
/// from points of Q alone. It is what an upper bound on d costs whose equations hold only up to a residual r,
/// as at a degenerate optimum. G is finite only if the points surround the origin.
///
/// For some p inside the cone of n points of Q, every p + r with |r|∞ <= s lies in that cone too, at no more
/// than twice the cost β of p itself. So r = (p + r) + (-p) costs at most 2β + gauge_Q(-p), and G is that
/// over s.
class GaugeBound {
 public:
  /// +infinity where nothing is proven.
  double compute(const ColumnPool& Q, int n, const Kernels& kernels, const Stopwatch& stopwatch);

  /// After compute() proved nothing: no multiple of the points of Q reaches the target, and all of them lie
  /// behind the plane of this normal. A point of Q along its opposite, if there is one, is what was missing.
  const double* normal() const noexcept { return program_.normal(); }

 private:
  double gauge_of_target(const ColumnPool& Q, double sign, const Stopwatch& stopwatch);

  int n_ = 0;
  const Kernels* kernels_ = nullptr;
  PrimalSimplex program_;
  ColumnPool target_;
  AlignedBuffer<double> point_;
};

}  // namespace raygauge
