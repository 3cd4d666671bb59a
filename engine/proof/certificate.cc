// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/proof/certificate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/double_double.h"
#include "engine/numerics/exact_sum.h"
#include "engine/numerics/floating_point.h"
#include "engine/sets/highest_points.h"

namespace raygauge {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr std::ptrdiff_t kDoubtful = 512;  // points that are worth a second, longer evaluation

// u·p_i, or (u + u_low)·p_i.
DoubleDouble exact_dot(const PointSet& S, std::ptrdiff_t i, const double* u, const double* u_low = nullptr) {
  const double* p =
      S.data() + (i / PointSet::kLanes) * S.dimension() * PointSet::kLanes + i % PointSet::kLanes;
  DoubleDouble sum;
  for (int k = 0; k < S.dimension(); ++k) {
    const double coordinate = p[static_cast<std::ptrdiff_t>(k) * PointSet::kLanes];
    DoubleDouble product = two_product(u[k], coordinate);
    if (u_low != nullptr) product.low += u_low[k] * coordinate;
    sum = sum + product;
  }
  return sum;
}

// (u + u_low)·p_i without rounding, to within an error.
ExactSum::Rounded rounded_dot(const PointSet& S, std::ptrdiff_t i, const double* u, const double* u_low) {
  const double* p =
      S.data() + (i / PointSet::kLanes) * S.dimension() * PointSet::kLanes + i % PointSet::kLanes;
  ExactSum sum;
  for (int k = 0; k < S.dimension(); ++k) {
    sum.add_product(u[k], p[static_cast<std::ptrdiff_t>(k) * PointSet::kLanes]);
    sum.add_product(u_low[k], p[static_cast<std::ptrdiff_t>(k) * PointSet::kLanes]);
  }
  return sum.rounded();
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

// The points of S that may attain h_S(u), given that to within an error.
class Doubtful {
 public:
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): see below
  Doubtful(const Kernels& kernels, const PointSet& S, const double* u, const SupportValue& h) {
    const double threshold = std::nextafter(h.value - 2 * h.error, -kInfinity);
    Collection collection{index_.data(), value_.data(), kDoubtful, 0, threshold};
    collect_points(kernels, S, u, collection);
    complete_ = collection.threshold == threshold;
    count_ = static_cast<std::size_t>(collection.count);
    for (std::size_t c = 0; c < count_; ++c) index_[c] = std::min<std::int64_t>(index_[c], S.size() - 1);
  }
  bool complete() const noexcept { return complete_; }  // whether there was room for all of them
  std::span<const std::int64_t> points() const noexcept { return {index_.data(), count_}; }

 private:
  // Filled by the collection as far as it counts; clearing 8 kB at every doubtful query would be waste.
  std::array<std::int64_t, kDoubtful> index_;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::array<double, kDoubtful> value_;        // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::size_t count_ = 0;
  bool complete_ = false;
};

// h_S(u + u_low), known to `h`, by sums free of rounding.
SupportValue exact_support_value(const PointSet& S, const Doubtful& doubtful, const SupportValue& h,
                                 const double* u, const double* u_low) {
  double value = -kInfinity;
  double error = 0;
  for (const std::int64_t i : doubtful.points()) {
    if (exact_dot(S, i, u, u_low).rounded() < h.value - 2 * h.error) continue;
    const ExactSum::Rounded product = rounded_dot(S, i, u, u_low);
    value = std::max(value, product.value);
    error = std::max(error, product.error);
  }
  return error < h.error ? SupportValue{value, error} : h;
}

// h_S(u + u_low) by one pass in twice the precision: where more points are in doubt than Doubtful holds.
SupportValue support_value_of_all(const Kernels& kernels, const PointSet& S, const double* u,
                                  const double* u_low, std::ptrdiff_t* index) {
  AlignedBuffer<double> values;
  values.reserve(static_cast<std::size_t>(S.block_count() * PointSet::kLanes));
  kernels.products_twofold(S.data(), S.block_count(), S.dimension(), u, u_low, values.data());
  *index = std::max_element(values.data(), values.data() + S.size()) - values.data();
  const double value = values[static_cast<std::size_t>(*index)];
  const double terms = S.dimension() + 4;
  const double lost = 1.01 * 4 * terms * terms * 0x1p-106 * dot_magnitude(S, u) + kUnderflow;
  return {value, std::fabs(value) * 2 * kUnitRoundoff + lost};
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
  const Highest highest = highest_point(kernels, S, u);
  SupportValue result{highest.value, dot_error(S, u)};
  if (index != nullptr) *index = highest.index;
  if (well_resolved(result.value, result.error, resolution)) return result;

  const Doubtful doubtful(kernels, S, u, result);
  if (!doubtful.complete()) return result;  // more of them than fit: the plain bound stands
  double best = -kInfinity;
  for (const std::int64_t i : doubtful.points()) best = std::max(best, exact_dot(S, i, u).rounded());
  const double lost = S.dimension() * 0x1p-100 * dot_magnitude(S, u) + kUnderflow;
  result.value = best;
  result.error = std::fabs(best) * 2 * kUnitRoundoff + lost;
  if (std::fabs(best) > lost) return result;
  // Zero within what double-double tells: is it exactly zero, at every point that may attain the maximum?
  for (const std::int64_t i : doubtful.points()) {
    const double value_i = exact_dot(S, i, u).rounded();
    if (value_i < -lost) continue;
    if (!dot_is_zero(S, i, u)) return result;
  }
  result = {0, 0};
  return result;
}

SupportValue support_value_twofold(const Kernels& kernels, const PointSet& S, const double* u,
                                   const double* u_low, std::ptrdiff_t* index) {
  const Highest highest = highest_point(kernels, S, u);
  std::ptrdiff_t best_index = highest.index;
  SupportValue result{highest.value, 0};
  // |u_low| <= 2⁻⁵² |u|, or it is no low part.
  double low_error = 0;
  for (int k = 0; k < S.dimension(); ++k) low_error += std::fabs(u_low[k]) * S.coordinate_magnitude()[k];
  result.error = dot_error(S, u) + 1.01 * low_error + kUnderflow;
  const Doubtful doubtful(kernels, S, u, result);
  if (doubtful.complete()) {
    double best = -kInfinity;
    for (const std::int64_t i : doubtful.points()) {
      const double value = exact_dot(S, i, u, u_low).rounded();
      if (value > best) best_index = i;
      best = std::max(best, value);
    }
    const double lost = (S.dimension() + 1) * 0x1p-99 * (dot_magnitude(S, u) + low_error) + kUnderflow;
    result = {best, std::fabs(best) * 2 * kUnitRoundoff + lost};
    if (!well_resolved(best, lost, kResolution / 64))
      result = exact_support_value(S, doubtful, result, u, u_low);
  }
  if (!doubtful.complete()) result = support_value_of_all(kernels, S, u, u_low, &best_index);
  if (index != nullptr) *index = best_index;
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
