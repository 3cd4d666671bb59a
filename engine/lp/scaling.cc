// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/scaling.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace raygauge {
namespace {

constexpr int kNoExponent = -5000;

int exponent_of(double magnitude) { return magnitude > 0 ? std::ilogb(magnitude) : kNoExponent; }

int largest_exponent(const PointSet& S, const int* shift) {
  int largest = kNoExponent;
  for (int k = 0; k < S.dimension(); ++k) {
    largest = std::max(largest, exponent_of(S.coordinate_magnitude()[k]) - shift[k]);
  }
  return largest <= kNoExponent / 2 || std::abs(largest) <= Scaling::kTolerated ? 0 : largest;
}

bool fill(AlignedBuffer<double>& factor, const int* shift, int common, int n) {
  bool trivial = true;
  for (int k = 0; k < n; ++k) {
    factor[static_cast<std::size_t>(k)] = std::ldexp(1.0, -(shift[k] + common));
    trivial = trivial && shift[k] + common == 0;
  }
  return trivial;
}

// Leaves room for directions as well, see direction_component().
constexpr double kLeastFactor = 0x1p-800;

// Whether every coordinate of S times its factor is exact.
bool scales_exactly(const PointSet& S, const double* factor) {
  for (int k = 0; k < S.dimension(); ++k) {
    if (!(factor[k] >= kLeastFactor && factor[k] <= 1 / kLeastFactor)) return false;
    if (!std::isfinite(S.coordinate_magnitude()[k] * factor[k])) return false;
    if (S.smallest_magnitude()[k] * factor[k] < std::numeric_limits<double>::min() && factor[k] != 1)
      return false;
  }
  return true;
}

bool scales_exactly(const ConvexSet& S, const double* factor) {
  const PointSet* points = as_point_set(S);
  return points != nullptr ? scales_exactly(*points, factor)
                           : factor[0] >= kLeastFactor && factor[0] <= 1 / kLeastFactor;
}

// Whether all magnitudes are so near to 1 and, in Q, to each other that nothing is to be scaled: what the
// exponents would say, in a few comparisons.
bool is_moderate(const PointSet& S, double least) {
  constexpr double kMost = 0x1p+4;
  static_assert(kMost == double{1 << Scaling::kTolerated});
  double largest = 0;
  double smallest = kMost;
  for (int k = 0; k < S.dimension(); ++k) {
    largest = std::max(largest, S.coordinate_magnitude()[k]);
    smallest = std::min(smallest, S.coordinate_magnitude()[k]);
  }
  return largest < kMost && largest >= 1 / kMost && smallest >= least * largest;
}

}  // namespace

void Scaling::compute(const PointSet& A, const PointSet& Q) {
  const int n = A.dimension();
  const auto size = static_cast<std::size_t>(n);
  factor_A_.reserve(size);
  factor_Q_.reserve(size);
  exponent_.reserve(size);
  constexpr double kLeast = 1.0 / (1 << (kRowSpread - 1));
  if (is_moderate(A, 0) && is_moderate(Q, kLeast)) return leave_alone(n);

  int top = kNoExponent;
  for (int k = 0; k < n; ++k) top = std::max(top, exponent_of(Q.coordinate_magnitude()[k]));
  for (int k = 0; k < n; ++k) {
    const int e = exponent_of(Q.coordinate_magnitude()[k]);
    exponent_[static_cast<std::size_t>(k)] = e > kNoExponent && e < top - kRowSpread ? e - top : 0;
  }
  const int common_A = largest_exponent(A, exponent_.data());
  const int common_Q = largest_exponent(Q, exponent_.data());
  trivial_A_ = fill(factor_A_, exponent_.data(), common_A, n);
  trivial_Q_ = fill(factor_Q_, exponent_.data(), common_Q, n);
  distance_shift_ = common_Q - common_A;
  if (scales_exactly(A, factor_A_.data()) && scales_exactly(Q, factor_Q_.data())) return;
  leave_alone(n);
}

void Scaling::compute_common(const ConvexSet& A, const ConvexSet& Q, double magnitude_A, double magnitude_Q) {
  const int n = A.dimension();
  const auto size = static_cast<std::size_t>(n);
  factor_A_.reserve(size);
  factor_Q_.reserve(size);
  leave_alone(n);
  const int of_Q = exponent_of(magnitude_Q), of_A = exponent_of(magnitude_A);
  if (!std::isfinite(magnitude_Q) || of_Q <= kNoExponent) return;
  const int common = std::abs(of_Q) <= kTolerated ? 0 : of_Q;
  const int small = of_A > kNoExponent && of_A < common - kTolerated ? of_A - common : 0;
  if (common == 0 && small == 0) return;
  std::fill_n(factor_A_.data(), n, std::ldexp(1.0, -common - small));
  std::fill_n(factor_Q_.data(), n, std::ldexp(1.0, -common));
  distance_shift_ = -small;
  trivial_A_ = common + small == 0;
  trivial_Q_ = common == 0;
  if (!scales_exactly(A, factor_A_.data()) || !scales_exactly(Q, factor_Q_.data())) leave_alone(n);
}

void Scaling::leave_alone(int n) {
  std::fill_n(factor_A_.data(), n, 1.0);
  std::fill_n(factor_Q_.data(), n, 1.0);
  trivial_A_ = trivial_Q_ = true;
  distance_shift_ = 0;
}

}  // namespace raygauge
