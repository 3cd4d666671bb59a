// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "engine/kernels/kernel.h"
#include "engine/lp/axis_points.h"
#include "engine/lp/column_pool.h"
#include "engine/lp/point_basis.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// A guess of the normal's direction (n doubles, the largest ±1) and of its relative error, which sets the
/// first bounds on the dual. Neither changes the answer; good ones save basis changes. With a `frame` that
/// brings Q (scaled as it is) into isotropic position, the artificial columns are ±F e_k instead of ±e_k, and
/// the bounds |F_k · u| <= cost: of a needle, bounds on the coordinates would say nothing about the one
/// direction that matters. Points of Q on the axes (`axes`, looked for over all of Q) take the place of
/// artificial columns.
struct FirstGuess {
  struct Frame {
    const double* F;        ///< n x n, column-major
    const double* inverse;  ///< F⁻¹
  };
  const double* normal = nullptr;
  double error = 0;
  const Frame* frame = nullptr;
  const AxisPoints* axes = nullptr;
};

/// Where PrimalSimplex starts.
class FirstBasis {
 public:
  void begin(int n, const Kernels& kernels);

  /// The point of A that the guess prefers, and artificial columns signed so that the basic solution is
  /// nonnegative: R is known in closed form.
  void guess(const ColumnPool& A, const ColumnPool& Q, const FirstGuess& first, PointBasis& basis,
             SimplexLoop& loop);

  /// These n + 1 columns; where weights are negative, those that some dual simplex steps lead to. False where
  /// there is no feasible basis.
  bool choose(const ColumnPool& A, const ColumnPool& Q, std::span<const std::int64_t> ids,
              const Stopwatch& stopwatch, PointBasis& basis);

 private:
  double price_guess(const PricedPoints& points, double sign, LaneList* lanes);
  void place_artificials(const double* a, const FirstGuess::Frame* frame, BasisView& view);
  void set_artificial_costs(double guess_error, const FirstGuess::Frame* frame, BasisView& view);
  bool exchange(const ColumnPool& A, const ColumnPool& Q, int row, PointBasis& basis);

  int n_ = 0;
  const Kernels* kernels_ = nullptr;
  AlignedBuffer<double> column_;
  AlignedBuffer<double> guess_;
  AlignedBuffer<double> white_;  // in the frame: n
  AlignedBuffer<float> single_;
};

}  // namespace raygauge
