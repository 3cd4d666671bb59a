// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/nearest_point/affine_basis.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

// Of a column's length what has to be left of it beside the others; below, it is rounding.
constexpr double kDependent = 1e-13;
// Gram-Schmidt twice where less than this is left: "twice is enough" (Kahan, Parlett).
constexpr double kOnceIsEnough = 0.5;

double length(const double* column, std::ptrdiff_t ld) {
  double sum = 0;
  for (std::ptrdiff_t k = 0; k < ld; ++k) sum += column[k] * column[k];
  return std::sqrt(sum);
}

}  // namespace

void AffineBasis::begin(int n, int sides, double sigma, const Kernels& kernels) {
  n_ = n;
  sides_ = sides;
  sigma_ = sigma;
  kernels_ = &kernels;
  count_ = 0;
  capacity_ = n + sides;
  ld_ = padded_rows(n + sides);
  row_ld_ = padded_rows(capacity_);
  const auto size = static_cast<std::size_t>(ld_);
  const auto capacity = static_cast<std::size_t>(capacity_);
  Q_.reserve(size * (capacity + 1));
  R_.reserve(static_cast<std::size_t>(row_ld_) * capacity);
  coefficients_.reserve(static_cast<std::size_t>(row_ld_));
  x_.reserve(static_cast<std::size_t>(row_ld_));
  sums_.reserve(size * 2);
  side_.reserve(capacity + 1);
  std::fill_n(R_.data(), row_ld_ * capacity_, 0.0);
  std::fill_n(sums_.data(), 2 * ld_, 0.0);
}

// sums_ is Σ_i q_i q_{i,l}ᵀ.
void AffineBasis::add_to_sums(int i, double sign) {
  const double* q = column(i);
  for (int t = 0; t < sides_; ++t) {
    const double share = sign * q[n_ + t];
    double* sum = sums_.data() + t * ld_;
    for (std::ptrdiff_t k = 0; k < ld_; ++k) sum[k] += share * q[k];
  }
}

bool AffineBasis::add(const double* point, int side) {
  if (count_ == capacity_) return false;
  double* q = column(count_);
  std::copy_n(point, n_, q);
  std::fill(q + n_, q + ld_, 0.0);
  q[n_ + side] = sigma_;
  double* coefficients = coefficients_.data();
  std::fill_n(coefficients, row_ld_, 0.0);
  const double whole = length(q, ld_);
  kernels_->project_out(Q_.data(), ld_, count_, q, coefficients);
  double left = length(q, ld_);
  if (left < kOnceIsEnough * whole) {
    kernels_->project_out(Q_.data(), ld_, count_, q, coefficients);
    left = length(q, ld_);
  }
  if (!(left > kDependent * whole)) return false;
  for (std::ptrdiff_t k = 0; k < ld_; ++k) q[k] /= left;
  for (int i = 0; i < count_; ++i) row(i)[count_] = coefficients[i];
  row(count_)[count_] = left;
  side_[static_cast<std::size_t>(count_)] = side;
  add_to_sums(count_++, 1);
  return true;
}

// Column i of R is taken out; rotations of its rows, and of the columns of Q, make it triangular again. QQ_lᵀ
// is the same after a rotation, and loses the column that is dropped.
void AffineBasis::remove(int i) {
  for (int r = 0; r < count_; ++r) {
    double* of_row = row(r);
    const int first = std::max(r, i + 1);
    std::copy(of_row + first, of_row + count_, of_row + first - 1);
    of_row[count_ - 1] = 0;
  }
  for (int r = i; r + 1 < count_; ++r) {
    const double a = row(r)[r];
    const double b = row(r + 1)[r];
    const double h = std::hypot(a, b);
    const std::ptrdiff_t first = r / kRowPadding * kRowPadding;
    kernels_->rotate(row(r) + first, row(r + 1) + first, row_ld_ - first, a / h, b / h);
    kernels_->rotate(column(r), column(r + 1), ld_, a / h, b / h);
    row(r + 1)[r] = 0;
  }
  std::copy(side_.data() + i + 1, side_.data() + count_, side_.data() + i);
  add_to_sums(--count_, -1);
}

bool AffineBasis::solve(double* weights, double* v) {
  double multipliers[2] = {0, 0};
  if (!solve_multipliers(multipliers)) return false;
  double* x = x_.data();
  std::fill_n(v, n_, 0.0);
  for (int i = 0; i < count_; ++i) {
    x[i] = 0;
    for (int t = 0; t < sides_; ++t) x[i] += column(i)[n_ + t] * multipliers[t];
  }
  kernels_->back_substitute(R_.data(), row_ld_, count_, x);
  for (int t = 0; t < sides_; ++t) {
    const double* sum = sums_.data() + t * ld_;
    for (int k = 0; k < n_; ++k) v[k] += multipliers[t] * sum[k];
  }
  std::copy_n(x, count_, weights);
  return std::all_of(x, x + count_, [](double weight) { return std::isfinite(weight); });
}

// ν of Q_l Q_lᵀ ν = σ 1, whose matrix is the last rows of sums_.
bool AffineBasis::solve_multipliers(double* multipliers) const {
  const double* H = sums_.data() + n_;
  if (sides_ == 1) {
    multipliers[0] = sigma_ / H[0];
    return H[0] > 0;
  }
  const double determinant = H[0] * H[ld_ + 1] - H[1] * H[ld_];
  multipliers[0] = sigma_ * (H[ld_ + 1] - H[ld_]) / determinant;
  multipliers[1] = sigma_ * (H[0] - H[1]) / determinant;
  return determinant > 0;
}

}  // namespace raygauge
