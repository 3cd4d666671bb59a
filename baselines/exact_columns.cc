// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

/// Exponents of p may span this much before a product with any double could underflow a long double.
constexpr long kLargestSpan = 8000;

/// Bounds the error of Σ p_k a_k relative to Σ|p_k a_k|: p is truncated to 53 bits (2^-52), and each of the
/// n + 3 roundings to long double adds 2^-64, so that this holds to n = 10000.
constexpr long double kUnit = 0x1p-50L;

void lower_exponents(const PointSet& set, std::vector<int>& lowest) {
  Vector point(set.dimension());
  for (std::ptrdiff_t i = 0; i < set.size(); ++i) {
    set.copy_point(i, point.data());
    for (int k = 0; k < set.dimension(); ++k) {
      if (point[k] == 0) continue;
      int& exponent = lowest[static_cast<std::size_t>(k)];
      exponent = std::min(exponent, to_dyadic(point[k]).exponent);
    }
  }
}

}  // namespace

ExactColumns::ExactColumns(const PointSet& A, const PointSet& Q) : A_(&A), Q_(&Q) {
  if (A.dimension() != Q.dimension()) {
    throw DimensionMismatchError("A lives in R^" + std::to_string(A.dimension()) + ", Q in R^" +
                                 std::to_string(Q.dimension()));
  }
  constexpr int kNone = std::numeric_limits<int>::max();
  std::vector<int> lowest(static_cast<std::size_t>(A.dimension()), kNone);
  lower_exponents(A, lowest);
  lower_exponents(Q, lowest);
  for (const int exponent : lowest) shift_.push_back(exponent == kNone ? 0 : -exponent);
  shift_.insert(shift_.end(), 2, 0);
}

void ExactColumns::copy(std::ptrdiff_t j, double* out) const noexcept {
  const int n = A_->dimension();
  if (is_gauge(j)) {
    Q_->copy_point(j - A_->size(), out);
    for (int k = 0; k < n; ++k) out[k] = -out[k];
  } else {
    A_->copy_point(j, out);
  }
  out[n] = is_gauge(j) ? 0.0 : 1.0;
  out[n + 1] = is_gauge(j) ? 1.0 : 0.0;
}

void ExactColumns::copy(std::ptrdiff_t j, IntegerVector& out) const {
  std::vector<double> column(static_cast<std::size_t>(rows()) + 1);
  copy(j, column.data());
  out.resize(column.size());
  for (std::size_t k = 0; k < column.size(); ++k) out[k] = scaled_integer(column[k], shift_[k]);
}

ExactProduct::ExactProduct(const ExactColumns& columns, const IntegerVector& p)
    : columns_(columns), p_(p), scaled_p_(p.size()), column_(p.size()), exact_column_(p.size()) {
  // p_k stands for the row scaled by 2^shift: p_k·2^shift belongs to the doubles themselves.
  std::vector<long> exponents(p.size());
  std::vector<double> mantissas(p.size());
  long highest = std::numeric_limits<long>::min(), lowest = std::numeric_limits<long>::max();
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p[k] == 0) continue;
    is_zero_ = false;
    mantissas[k] = mpz_get_d_2exp(&exponents[k], p[k].backend().data());
    exponents[k] += columns.shift(static_cast<int>(k));
    highest = std::max(highest, exponents[k]);
    lowest = std::min(lowest, exponents[k]);
  }
  if (is_zero_) return;
  in_range_ = highest - lowest <= kLargestSpan;
  for (std::size_t k = 0; k < p.size() && in_range_; ++k) {
    scaled_p_[k] =
        std::ldexp(static_cast<long double>(mantissas[k]), static_cast<int>(exponents[k] - highest));
  }
}

ExactProduct::Sign ExactProduct::sign(std::ptrdiff_t j) {
  if (is_zero_) return {};
  long double sum = 0, magnitude = 0;
  if (in_range_) {
    columns_.copy(j, column_.data());
    for (std::size_t k = 0; k < column_.size(); ++k) {
      const long double term = scaled_p_[k] * column_[k];
      sum += term;
      magnitude += std::abs(term);
    }
    if (std::abs(sum) > kUnit * magnitude) return {sum > 0 ? 1 : -1, std::abs(sum)};
  }
  return {exact(j).sign(), std::abs(sum)};
}

Integer ExactProduct::exact(std::ptrdiff_t j) {
  columns_.copy(j, exact_column_);
  Integer sum = 0;
  for (std::size_t k = 0; k < p_.size(); ++k) sum += p_[k] * exact_column_[k];
  return sum;
}

}  // namespace raygauge
