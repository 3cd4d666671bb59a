// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/twofold_basis.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/exact_sum.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Each step multiplies the error by ‖I - R B‖, 10⁻¹² or so at a condition of 10¹⁸.
constexpr int kSolutionSteps = 2;
constexpr int kDualSteps = 2;

// The least pivot of a column that is placed: below, it depends on those before.
constexpr double kIndependent = 0x1p-85;

constexpr double kRoundedUp = 1.01;  // of a few hundred operations on positive numbers

// Of Kernels::multiply_twofold, relative to Σ|terms|.
double product_error(int m) { return 4.0 * (m + 4) * (m + 4) * 0x1p-106; }

void clear(AlignedBuffer<double>& buffer, std::size_t count) {
  buffer.reserve(count);
  std::fill_n(buffer.data(), count, 0.0);
}

// x^0 + x^1 + x^2 += change, the parts ordered by magnitude again: where the first ones cancel, it takes a
// second turn.
void add(TwofoldBasis::Solution& x, std::size_t i, double change, double change_low) {
  DoubleDouble first = two_sum(x.part[0][i], change);
  DoubleDouble second = two_sum(x.part[1][i], first.low);
  double third = x.part[2][i] + second.low + change_low;
  for (int turn = 0; turn < 2; ++turn) {
    first = two_sum(first.high, second.high);
    second = two_sum(first.low, third);
    third = second.low;
  }
  x.part[0][i] = first.high;
  x.part[1][i] = second.high;
  x.part[2][i] = third;
}

}  // namespace

void TwofoldBasis::reset(int m, const Kernels& kernels) {
  kernels_ = &kernels;
  m_ = m;
  P_ = padded_rows(m);
  for (AlignedBuffer<double>* matrix : {&R_, &R_low_, &B_}) clear(*matrix, at(m) * at(P_));
  for (AlignedBuffer<double>* vector : {&w_, &w_low_, &scale_, &scale_low_, &rows_}) clear(*vector, at(P_));
  id_.reserve(at(m));
  taken_.reserve(at(m));
  for (int i = 0; i < m_; ++i) set_unit(i, 1.0);
}

// Where R is the unit matrix in row and column i.
void TwofoldBasis::set_unit(int i, double sign) {
  R_[entry(i, i)] = B_[entry(i, i)] = sign;
  id_[at(i)] = kArtificial;
  taken_[at(i)] = false;
}

bool TwofoldBasis::is_unit(int i) const {
  if (!is_artificial(i) || std::fabs(column(i)[i]) != 1) return false;
  for (int k = 0; k < m_; ++k) {
    if (k != i && column(i)[k] != 0) return false;
  }
  return true;
}

void TwofoldBasis::refactor() {
  const std::size_t size = at(m_) * at(P_);
  columns_.reserve(size);
  ids_.reserve(at(m_));
  std::copy_n(B_.data(), size, columns_.data());
  std::copy_n(id_.data(), m_, ids_.data());
  // The signs of the artificial unit columns, which are placed first; 0 for the others.
  for (int i = 0; i < m_; ++i) rows_[at(i)] = is_unit(i) ? column(i)[i] : 0.0;
  for (AlignedBuffer<double>* matrix : {&R_, &R_low_, &B_}) clear(*matrix, size);
  for (int i = 0; i < m_; ++i) {
    set_unit(i, rows_[at(i)] != 0 ? rows_[at(i)] : 1.0);
    taken_[at(i)] = rows_[at(i)] != 0;
  }
  for (int i = 0; i < m_; ++i) {
    if (rows_[at(i)] == 0) place(columns_.data() + entry(0, i), ids_[at(i)]);
  }
  improve();
}

void TwofoldBasis::improve() {
  double* E = columns_.data();
  for (int j = 0; j < m_; ++j) {
    transform(column(j));
    double* E_j = E + entry(0, j);
    for (int i = 0; i < m_; ++i) E_j[i] = (i == j ? 1 - w_[at(i)] : -w_[at(i)]) - w_low_[at(i)];
  }
  for (int k = 0; k < m_; ++k) {
    double* change = scale_.data();
    std::fill_n(change, m_, 0.0);
    for (int j = 0; j < m_; ++j) {
      const double factor = R_[entry(j, k)];
      const double* E_j = E + entry(0, j);
      for (int i = 0; i < m_; ++i) change[i] += factor * E_j[i];
    }
    for (int i = 0; i < m_; ++i) {
      const DoubleDouble improved = R(i, k) + change[i];
      R_[entry(i, k)] = improved.high;
      R_low_[entry(i, k)] = improved.low;
    }
  }
}

bool TwofoldBasis::place(const double* column, std::int64_t id) {
  transform(column);
  int row = -1;
  double largest = kIndependent;
  for (int i = 0; i < m_; ++i) {
    if (taken_[at(i)] || !(std::fabs(w_[at(i)]) > largest)) continue;
    largest = std::fabs(w_[at(i)]);
    row = i;
  }
  if (row < 0) return false;
  replace(row, column, id);
  taken_[at(row)] = true;
  return true;
}

void TwofoldBasis::transform(const double* column) {
  kernels_->multiply_twofold(R_.data(), R_low_.data(), P_, m_, column, w_.data(), w_low_.data());
}

// R_r /= w_r, and R_i -= w_i R_r of that for the other rows.
void TwofoldBasis::replace(int r, const double* column, std::int64_t id) {
  const DoubleDouble inverse = DoubleDouble{1} / w(r);
  for (int k = 0; k < m_; ++k) {
    const DoubleDouble scale = R(r, k) * inverse;
    scale_[at(k)] = scale.high;
    scale_low_[at(k)] = scale.low;
  }
  kernels_->subtract_product_twofold(R_.data(), R_low_.data(), P_, m_, w_.data(), w_low_.data(),
                                     scale_.data(), scale_low_.data());
  for (int k = 0; k < m_; ++k) {
    R_[entry(r, k)] = scale_[at(k)];
    R_low_[entry(r, k)] = scale_low_[at(k)];
  }
  std::copy_n(column, m_, B_.data() + entry(0, r));
  id_[at(r)] = id;
}

void TwofoldBasis::make_artificial(int i) {
  for (int k = 0; k < m_; ++k) {
    R_[entry(i, k)] = -R_[entry(i, k)];
    R_low_[entry(i, k)] = -R_low_[entry(i, k)];
    B_[entry(k, i)] = -B_[entry(k, i)];
  }
  id_[at(i)] = kArtificial;
}

void TwofoldBasis::norms_of_rows(double* norm) const {
  std::fill_n(norm, m_, 0.0);
  for (int k = 0; k < m_; ++k) {
    for (int i = 0; i < m_; ++i) norm[i] += std::fabs(R_[entry(i, k)]);
  }
}

// ‖R‖∞, rounded up.
double TwofoldBasis::norm() const {
  AlignedBuffer<double> norm;
  norm.reserve(at(m_));
  norms_of_rows(norm.data());
  double largest = 0;
  for (int i = 0; i < m_; ++i) {
    if (!(norm[at(i)] <= largest)) largest = norm[at(i)];  // NaN stays
    if (std::isnan(largest)) break;
  }
  return kRoundedUp * largest;
}

double TwofoldBasis::residual_share() {
  std::fill_n(rows_.data(), at(P_), 0.0);
  double norm_of_B = 0;  // max_j Σ_k |B_kj| >= |B_kj|: ‖|R||B|‖∞ <= ‖R‖∞ m max|B_kj|
  for (int j = 0; j < m_; ++j) {
    transform(column(j));
    for (int i = 0; i < m_; ++i) {
      const double rest = (i == j ? w_[at(i)] - 1 : w_[at(i)]) + w_low_[at(i)];
      rows_[at(i)] += std::fabs(rest) + 4 * kUnitRoundoff * std::fabs(rest);
    }
    for (int k = 0; k < m_; ++k) norm_of_B = std::max(norm_of_B, std::fabs(column(j)[k]));
  }
  double largest = 0;
  for (int i = 0; i < m_; ++i) {
    if (!(rows_[at(i)] <= largest)) largest = rows_[at(i)];
    if (std::isnan(largest)) return kInfinity;
  }
  const double rounding = (product_error(m_) + 0x1p-104) * norm() * m_ * norm_of_B;
  return kRoundedUp * (largest + rounding) + kUnderflow;
}

// b_k - Σ_i B_ki Σ_c x^c_i.
double TwofoldBasis::residual_of_row(const Solution& x, int k, double* error) const {
  ExactSum sum;
  if (k == m_ - 1) sum.add(1.0);
  for (int i = 0; i < m_; ++i) {
    const double entry_of_B = B_[entry(k, i)];
    for (const auto& part : x.part) sum.add_product(-entry_of_B, part[at(i)]);
  }
  const ExactSum::Rounded rounded = sum.rounded();
  *error = rounded.error;
  return rounded.value;
}

// A bound on |R (b - B x)|∞. With `correcting`, x += R (b - B x) after that.
double TwofoldBasis::refine(Solution& x, bool correcting) {
  double* r = scale_.data();
  double largest = 0, uncertain = 0;
  for (int k = 0; k < m_; ++k) {
    double error = 0;
    r[k] = residual_of_row(x, k, &error);
    largest = std::max(largest, std::fabs(r[k]));
    if (!(error <= uncertain)) uncertain = error;
  }
  if (!(uncertain < kInfinity)) return kInfinity;
  transform(r);
  double step = 0;
  for (int i = 0; i < m_; ++i) {
    if (!(std::fabs(w_[at(i)]) <= step)) step = std::fabs(w_[at(i)]);
    if (correcting) add(x, at(i), w_[at(i)], w_low_[at(i)]);
  }
  const double lost = norm() * (product_error(m_) * m_ * largest + uncertain);
  return kRoundedUp * (step + lost) + kUnderflow;
}

// Rump: |x* - x|∞ <= |R (b - B x)|∞ / (1 - ‖I - R B‖∞).
void TwofoldBasis::solve(Solution& x) {
  for (auto& part : x.part) clear(part, at(P_));
  for (int i = 0; i < m_; ++i) {
    x.part[0][at(i)] = this->x(i).high;
    x.part[1][at(i)] = this->x(i).low;
  }
  x.error = kInfinity;
  const double share = residual_share();
  if (!(share < 0.5)) return;
  for (int step = 0; step < kSolutionSteps; ++step) refine(x, true);
  const double error = refine(x, false);
  if (std::isfinite(error)) x.error = kRoundedUp * error / (1 - share);
}

void TwofoldBasis::refine_duals(std::span<const double> cost, double* y, double* y_low) {
  double* rest = scale_.data();
  for (int step = 0; step < kDualSteps; ++step) {
    for (int i = 0; i < m_; ++i) {
      ExactSum sum;
      sum.add(cost[at(i)]);
      for (int k = 0; k < m_; ++k) {
        sum.add_product(-column(i)[k], y[k]);
        sum.add_product(-column(i)[k], y_low[k]);
      }
      rest[i] = sum.rounded().value;
    }
    for (int k = 0; k < m_; ++k) {
      DoubleDouble change;
      for (int i = 0; i < m_; ++i) change = change + R(i, k) * rest[i];
      const DoubleDouble refined = DoubleDouble{y[k], y_low[k]} + change;
      y[k] = refined.high;
      y_low[k] = refined.low;
    }
  }
}

}  // namespace raygauge
