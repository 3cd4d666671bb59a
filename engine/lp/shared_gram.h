// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/threads/helpers.h"

namespace raygauge {

/// The matrix G = Σ_p w_p p pᵀ over points of R^n, and its Cholesky factor. Threads share the stripes of its
/// rows; every entry is summed in the same order, so that the number of threads does not change a bit.
class SharedGram {
 public:
  /// G = 0. Memory for n is kept.
  void begin(int n, const Kernels& kernels, const Helpers& helpers);

  /// Adds the points of the blocks, as many weights >= 0 as lanes; those of weight 0 cost nothing. With
  /// `single` the products are in single precision, in half the time.
  void add(const PricedPoints& points, const double* weight, bool single);

  /// G becomes L, G = L Lᵀ, in the lower triangle. False where it is not positive definite.
  bool factor();

  /// Column-major, the lower triangle of n columns of rows() entries.
  const double* data() const noexcept { return matrix_.data(); }
  double* data() noexcept { return matrix_.data(); }
  int rows() const noexcept { return rows_; }

 private:
  void add_batch(const double* blocks, const GramPoint* points, int count, bool single);
  void add_panels(int n, int depth, bool single, double sign, double* M);

  int n_ = 0;
  int rows_ = 0;  // of the matrix: no power of two, for columns that far apart share the cache badly
  const Kernels* kernels_ = nullptr;
  Helpers helpers_;
  AlignedBuffer<double> matrix_;
  AlignedBuffer<double> panels_;
  std::vector<GramPoint> chosen_;
};

}  // namespace raygauge
