// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/bounded_inverse.h"

#include <cmath>
#include <limits>

#include "engine/numerics/decompositions.h"

namespace raygauge {
namespace {

constexpr double kLargestDefect = 1e-3;  // of an inverse that is worth anything

// ‖X‖₂² = ‖XᵀX‖₂ <= ‖XᵀX‖_∞, which is sharp for multiples of rotations.
double spectral_norm_bound(const DenseMatrix& X, double frobenius) {
  const Eigen::Index n = X.rows();
  const double rounding = static_cast<double>(n + 4) * std::numeric_limits<double>::epsilon();
  const double square = (X.transpose() * X).cwiseAbs().rowwise().sum().maxCoeff();
  const double bound = std::sqrt(square + static_cast<double>(n) * rounding * frobenius * frobenius);
  return std::isnormal(square) && bound < frobenius ? bound * (1 + rounding) : frobenius;
}

}  // namespace

BoundedInverse::BoundedInverse(const DenseMatrix& L) {
  const Eigen::Index n = L.rows();
  if (n != L.cols()) return;
  inverse_ = lu_inverse(L);
  norm_ = inverse_.norm();
  const double rounding = 2 * static_cast<double>(n + 4) * std::numeric_limits<double>::epsilon();
  defect_ = (inverse_ * L - Eigen::MatrixXd::Identity(n, n)).norm() + rounding * norm_ * L.norm();
  if (!(defect_ < kLargestDefect) || !std::isfinite(norm_)) {
    inverse_.resize(0, 0);
    return;
  }
  least_stretch_ = (1 - defect_) / spectral_norm_bound(inverse_, norm_) * (1 - rounding);
}

double BoundedInverse::image_length(const double* p, const double* q) const noexcept {
  const Eigen::Index n = inverse_.rows();
  if (n == 0) return std::numeric_limits<double>::infinity();
  double square = 0, way = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    double row = 0;
    for (Eigen::Index k = 0; k < n; ++k) row += inverse_(i, k) * (p[k] - q[k]);
    square += row * row;
    way += (p[i] - q[i]) * (p[i] - q[i]);
  }
  const double rounding = static_cast<double>(n + 4) * std::numeric_limits<double>::epsilon();
  return (std::sqrt(square) + rounding * norm_ * std::sqrt(way)) / (1 - defect_) * (1 + rounding);
}

}  // namespace raygauge
