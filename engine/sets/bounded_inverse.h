// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/numerics/dense.h"

namespace raygauge {

/// An approximate inverse X of a square matrix L, with what it proves of L: ‖1 - X L‖ <= e < 1, e including
/// the rounding errors of that product, gives
///
///     min |L z|/|z| >= (1 - e)/‖X‖,      |L⁻¹v| <= |X v|/(1 - e),
///
/// in Frobenius norms, and for ‖X‖ in the spectral norm, bounded by (‖XᵀX‖_∞)^(1/2).
class BoundedInverse {
 public:
  BoundedInverse() = default;

  /// Proves nothing if L is not square, or is singular to working precision.
  explicit BoundedInverse(const DenseMatrix& L);

  /// A lower bound on min |L z|/|z|, the least singular value of L; 0 where nothing is proven.
  double least_stretch() const noexcept { return least_stretch_; }

  /// An upper bound on |L⁻¹(p - q)|, p and q arrays of n doubles; +infinity where nothing is proven.
  double image_length(const double* p, const double* q) const noexcept;

  /// X, empty where nothing is proven.
  const DenseMatrix& inverse() const noexcept { return inverse_; }

 private:
  DenseMatrix inverse_;
  double norm_ = 0;    // of X, Frobenius
  double defect_ = 1;  // e
  double least_stretch_ = 0;
};

}  // namespace raygauge
