// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "raygauge/numerics/quad.h"

namespace raygauge {

// Small vectors as raw arrays: what the support functions of the closed-form sets are made of, in
// double or in quadruple precision. Nothing allocates.

/// u·v, in the more precise of the two types.
template <class Real, class Other>
auto dot(const Real* u, const Other* v, int n) noexcept -> decltype(*u * *v) {
  decltype(*u * *v) sum = 0;
  for (int k = 0; k < n; ++k) sum += u[k] * v[k];
  return sum;
}

/// max_k |u_k|.
template <class Real>
Real largest_magnitude(const Real* u, int n) noexcept {
  Real largest = 0;
  for (int k = 0; k < n; ++k) largest = std::max(largest, elementary::fabs(u[k]));
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

/// The same in quadruple precision, whose range the squares of doubles do not leave.
inline Quad normalize(const Quad* u, int n, Quad* unit) noexcept {
  const Quad length = elementary::sqrt(dot(u, u, n));
  for (int k = 0; k < n; ++k) unit[k] = length > 0 ? u[k] / length : Quad{0};
  return length;
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
inline Quad length(const Quad* u, int n) noexcept { return elementary::sqrt(dot(u, u, n)); }

/// What is proven of a length computed from numbers of magnitude `size` in some tens of operations per
/// coordinate: `length` less its rounding error; 0 where nothing is left.
inline double proven_length(double length, double size, int n) noexcept {
  const double left = length - (16 * n + 64) * 0x1p-53 * size;
  return left > 0 ? left : 0.0;
}

/// The Hessian of factor · |u|: factor/|u| (1 - ûûᵀ), û = u/|u|, n × n.
template <class Real>
void norm_hessian(const Real* unit, Real factor_by_length, int n, Real* hessian) noexcept {
  for (int j = 0; j < n; ++j) {
    for (int k = 0; k < n; ++k) hessian[j * n + k] = -factor_by_length * unit[j] * unit[k];
    hessian[j * n + j] += factor_by_length;
  }
}

/// An array of `size` numbers, not initialised: on the stack up to kOnStack, which is every dimension anybody
/// has asked for; on the heap beyond.
template <class Real>
class BasicScratch {
 public:
  static constexpr int kOnStack = 128;

  explicit BasicScratch(int size) {
    if (size > kOnStack) heap_ = std::make_unique<Real[]>(static_cast<std::size_t>(size));
  }
  BasicScratch(const BasicScratch&) = delete;
  BasicScratch& operator=(const BasicScratch&) = delete;

  Real* data() noexcept { return heap_ ? heap_.get() : stack_; }

 private:
  Real stack_[kOnStack];
  std::unique_ptr<Real[]> heap_;
};

using Scratch = BasicScratch<double>;

/// |u - v|.
inline double distance_between(const double* u, const double* v, int n) {
  Scratch difference(n);
  for (int k = 0; k < n; ++k) difference.data()[k] = u[k] - v[k];
  return length(difference.data(), n);
}

}  // namespace raygauge
