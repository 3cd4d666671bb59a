// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/certificates/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/numerics/double_double.h"
#include "engine/numerics/exact_sum.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr std::ptrdiff_t kDoubtful = 512;  // points that are worth a second, longer evaluation

DoubleDouble exact_dot(const PointSet& S, std::ptrdiff_t i, const double* u) {
  const double* p =
      S.data() + (i / PointSet::kLanes) * S.dimension() * PointSet::kLanes + i % PointSet::kLanes;
  DoubleDouble sum;
  for (int k = 0; k < S.dimension(); ++k)
    sum = sum + two_product(u[k], p[static_cast<std::ptrdiff_t>(k) * PointSet::kLanes]);
  return sum;
}

bool dot_is_zero(const PointSet& S, std::ptrdiff_t i, const double* u) {
  const double* p =
      S.data() + (i / PointSet::kLanes) * S.dimension() * PointSet::kLanes + i % PointSet::kLanes;
  ExactSum sum;
  for (int k = 0; k < S.dimension(); ++k)
    sum.add_product(u[k], p[static_cast<std::ptrdiff_t>(k) * PointSet::kLanes]);
  return sum.is_zero();
}

// Σ_k |u_k| max_i |p_ik|, rounded up.
double dot_magnitude(const PointSet& S, const double* u) {
  double sum = 0;
  for (int k = 0; k < S.dimension(); ++k) sum += std::fabs(u[k]) * S.coordinate_magnitude()[k];
  return sum * (1 + 2 * (S.dimension() + 1) * kUnitRoundoff);
}

}  // namespace

double scaled_down(double value, int shift) noexcept {
  if (shift == 0) return value;
  const double result = std::ldexp(value, shift);
  if (std::isinf(result)) return std::isinf(value) ? value : kLargest;
  return std::isnormal(result) || result == 0 ? result : std::nextafter(result, 0.0);
}

double scaled_up(double value, int shift) noexcept {
  if (shift == 0) return value;
  const double result = std::ldexp(value, shift);
  return std::isnormal(result) || value == 0 || std::isinf(result) ? result
                                                                   : std::nextafter(result, kInfinity);
}

double dot_error(const PointSet& S, const double* u) {
  // Products below the normal range have no bound on their relative errors.
  return dot_magnitude(S, u) * (1.01 * (S.dimension() + 1) * kUnitRoundoff) + kUnderflow;
}

SupportValue support_value(const Kernels& kernels, const PointSet& S, const double* u, std::ptrdiff_t* index,
                           double resolution) {
  std::ptrdiff_t best_index = 0;
  SupportValue result;
  result.value = kernels.price(S.data(), S.block_count(), S.dimension(), u, &best_index);
  result.error = dot_error(S, u);
  best_index = std::min(best_index, S.size() - 1);
  if (index != nullptr) *index = best_index;
  if (well_resolved(result.value, result.error, resolution)) return result;

  // Filled by the collection as far as it counts; clearing 8 kB at every doubtful query would be waste.
  std::array<std::int64_t, kDoubtful> doubtful;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::array<double, kDoubtful> value;           // NOLINT(cppcoreguidelines-pro-type-member-init)
  const double threshold = std::nextafter(result.value - 2 * result.error, -kInfinity);
  Collection collection{doubtful.data(), value.data(), kDoubtful, 0, threshold};
  kernels.collect(S.data(), 0, S.block_count(), S.dimension(), u, &collection);
  if (collection.threshold != threshold) return result;  // more of them than fit: the plain bound stands
  double best = -kInfinity;
  for (std::ptrdiff_t c = 0; c < collection.count; ++c) {
    best = std::max(
        best, exact_dot(S, std::min<std::ptrdiff_t>(doubtful[static_cast<std::size_t>(c)], S.size() - 1), u)
                  .rounded());
  }
  const double lost = S.dimension() * 0x1p-100 * dot_magnitude(S, u) + kUnderflow;
  result.value = best;
  result.error = std::fabs(best) * 2 * kUnitRoundoff + lost;
  if (std::fabs(best) > lost) return result;
  // Zero within what double-double tells: is it exactly zero, at every point that may attain the maximum?
  for (std::ptrdiff_t c = 0; c < collection.count; ++c) {
    const std::ptrdiff_t i = std::min<std::ptrdiff_t>(doubtful[static_cast<std::size_t>(c)], S.size() - 1);
    const double value_i = exact_dot(S, i, u).rounded();
    if (value_i < -lost) continue;
    if (!dot_is_zero(S, i, u)) return result;
  }
  result = {0, 0};
  return result;
}

double lower_bound(const SupportValue& h_A, const SupportValue& h_Q) noexcept {
  const double above_A = h_A.above() + std::fabs(h_A.value) * 2 * kUnitRoundoff;
  if (!(above_A < 0)) return 0;
  const double above_Q = h_Q.above();
  if (above_Q <= 0) return kInfinity;
  if (!(above_Q < kInfinity)) return 0;
  // Infinity is for Farkas directions: a quotient that overflows is only known to exceed every double.
  const double quotient =
      std::min(-above_A / (above_Q * (1 + 2 * kUnitRoundoff)) * (1 - 4 * kUnitRoundoff), kLargest);
  // Below the normal range the division is rounded to nearest with no relative error bound.
  return std::isnormal(quotient) || quotient == 0 ? quotient : std::nextafter(quotient, 0.0);
}

double rounded_down(Quad x) noexcept {
  const auto nearest = static_cast<double>(x);
  return nearest > x ? std::nextafter(nearest, 0.0) : nearest;
}

double rounded_up(Quad x) noexcept {
  const auto nearest = static_cast<double>(x);
  return nearest < x ? std::nextafter(nearest, kInfinity) : nearest;
}

template <class Real>
double lower_bound(const BasicSupportValue<Real>& h_A, const BasicSupportValue<Real>& h_Q) noexcept {
  const Real above_A = h_A.above();
  if (!(above_A < 0)) return 0;
  const Real above_Q = h_Q.above();
  if (above_Q <= 0) return kInfinity;
  if (!(above_Q < kInfinity)) return 0;
  constexpr double kFewRoundings = 8 * kRoundoff<Quad>;
  return std::min(rounded_down(-above_A / above_Q * (1 - Quad{kFewRoundings})), kLargest);
}

template double lower_bound(const QuadSupportValue&, const QuadSupportValue&) noexcept;

}  // namespace raygauge
