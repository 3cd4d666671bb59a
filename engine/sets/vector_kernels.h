// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

namespace raygauge {

// Small vectors as raw arrays: what the support functions of the closed-form sets are made of. Nothing
// allocates.

/// u·v.
inline double dot(const double* u, const double* v, int n) noexcept {
  double sum = 0;
  for (int k = 0; k < n; ++k) sum += u[k] * v[k];
  return sum;
}

/// max_k |u_k|.
inline double largest_magnitude(const double* u, int n) noexcept {
  double largest = 0;
  for (int k = 0; k < n; ++k) largest = std::max(largest, std::fabs(u[k]));
  return largest;
}

inline constexpr double kTinySquare = 0x1p-900, kHugeSquare = 0x1p900;

/// |u|, and u/|u| in `unit` (zero for u = 0); `unit` may be u itself. Squares neither overflow nor underflow:
/// where they would, u is first scaled by a power of two.
inline double normalize(const double* u, int n, double* unit) noexcept {
  const double square = dot(u, u, n);
  if (square > kTinySquare && square < kHugeSquare) {
    const double length = std::sqrt(square);
    for (int k = 0; k < n; ++k) unit[k] = u[k] / length;
    return length;
  }
  const double largest = largest_magnitude(u, n);
  if (largest == 0) {
    std::fill_n(unit, n, 0.0);
    return 0;
  }
  const int exponent = std::ilogb(largest);
  for (int k = 0; k < n; ++k) unit[k] = std::scalbn(u[k], -exponent);
  const double length = std::sqrt(dot(unit, unit, n));
  for (int k = 0; k < n; ++k) unit[k] /= length;
  return std::scalbn(length, exponent);
}

/// |u|, as normalize() computes it.
inline double length(const double* u, int n) noexcept {
  const double square = dot(u, u, n);
  if (square > kTinySquare && square < kHugeSquare) return std::sqrt(square);
  const double largest = largest_magnitude(u, n);
  if (largest == 0) return 0;
  const int exponent = std::ilogb(largest);
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    const double scaled = std::scalbn(u[k], -exponent);
    sum += scaled * scaled;
  }
  return std::scalbn(std::sqrt(sum), exponent);
}

/// What is proven of a length computed from numbers of magnitude `size` in some tens of operations per
/// coordinate: `length` less its rounding error; 0 where nothing is left.
inline double proven_length(double length, double size, int n) noexcept {
  const double left = length - (16 * n + 64) * 0x1p-53 * size;
  return left > 0 ? left : 0.0;
}

/// The Hessian of factor · |u|: factor/|u| (1 - ûûᵀ), û = u/|u|, n × n.
inline void norm_hessian(const double* unit, double factor_by_length, int n, double* hessian) noexcept {
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) hessian[j * n + k] = -factor_by_length * unit[j] * unit[k];
    hessian[j * n + j] += factor_by_length;
  }
}

/// An array of `size` doubles, not initialised: on the stack up to kOnStack, which is every dimension anybody
/// has asked for; on the heap beyond.
class Scratch {
 public:
  static constexpr int kOnStack = 128;

  explicit Scratch(int size) {
    if (size > kOnStack) heap_ = std::make_unique<double[]>(static_cast<std::size_t>(size));
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  double* data() noexcept { return heap_ ? heap_.get() : stack_; }

 private:
  double stack_[kOnStack];
  std::unique_ptr<double[]> heap_;
};

/// |u - v|.
inline double distance_between(const double* u, const double* v, int n) {
  Scratch difference(n);
  for (int k = 0; k < n; ++k) difference.data()[k] = u[k] - v[k];
  return length(difference.data(), n);
}

}  // namespace raygauge
