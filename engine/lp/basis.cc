// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/basis.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "engine/lp/affords.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// A pivot of the equilibrated column below this makes the matrix numerically singular.
constexpr double kSingular = 1e-14;

// Columns and rows that a thread takes at a time.
constexpr int kTogether = 64;
int parts_of(int count) { return (count + kTogether - 1) / kTogether; }

}  // namespace

void Basis::reset(int m, const Kernels& kernels) {
  kernels_ = &kernels;
  const int P = padded_rows(m);
  const std::size_t matrix = static_cast<std::size_t>(P) * static_cast<std::size_t>(m + 1);
  const std::size_t scratch = 19 * static_cast<std::size_t>(P);
  const std::size_t changes = many_rows(m) ? kMostPending * static_cast<std::size_t>(P) : 0;
  const std::size_t total = 2 * matrix + 2 * changes + 6 * static_cast<std::size_t>(P) + scratch;
  memory_.reserve(total);
  ids_.reserve(static_cast<std::size_t>(P));
  b_.reserve(static_cast<std::size_t>(P));
  std::memset(memory_.data(), 0, total * sizeof(double));
  std::memset(b_.data(), 0, static_cast<std::size_t>(P) * sizeof(double));
  view_ = {};
  norms_pivots_ = -1;
  view_.m = m;
  view_.P = P;
  double* next = memory_.data();
  const auto take = [&next](std::size_t count) { return std::exchange(next, next + count); };
  view_.R = take(matrix);
  view_.B = take(matrix);
  view_.y = take(static_cast<std::size_t>(P));
  view_.cost = take(static_cast<std::size_t>(P));
  view_.w = take(static_cast<std::size_t>(P));
  view_.scratch = take(3 * static_cast<std::size_t>(P));
  view_.columns = take(scratch);
  view_.changes = take(changes);
  view_.change_rows = take(changes);
  view_.id = ids_.data();
}

void Basis::set_column(int i, const double* column, double cost, std::int64_t id) {
  std::copy_n(column, view_.m, view_.B + static_cast<std::ptrdiff_t>(i) * view_.P);
  view_.cost[i] = cost;
  view_.id[i] = id;
}

bool Basis::refactor() {
  norms_pivots_ = -1;
  view_.pending = 0;
  if (!invert()) return false;
  const int m = view_.m;
  double* x = view_.x();
  std::fill_n(x, view_.P, 0.0);
  for (int k = 0; k < m; ++k) {
    const double b = b_[static_cast<std::size_t>(k)];
    if (b == 0) continue;
    const double* column_of_R = view_.R + static_cast<std::ptrdiff_t>(k) * view_.P;
    for (int i = 0; i < m; ++i) x[i] += column_of_R[i] * b;
  }
  refresh_duals();
  return true;
}

// R stays as it was where B is singular.
bool Basis::invert() {
  const std::size_t size = static_cast<std::size_t>(view_.m) * static_cast<std::size_t>(view_.P);
  factor_.reserve(size);
  exchanged_.reserve(static_cast<std::size_t>(view_.m));
  double* M = factor_.data();
  std::copy_n(view_.B, size, M);
  const bool regular = view_.m <= kTogether
                           ? kernels_->invert(M, view_.P, view_.m, kSingular, exchanged_.data())
                           : invert_together(M, exchanged_.data());
  if (regular) std::copy_n(M, size, view_.R);
  return regular;
}

bool Basis::invert_together(double* M, int* exchanged) const {
  const int m = view_.m;
  const std::ptrdiff_t P = view_.P;
  for (int first = 0; first < m; first += kPivotsAtOnce) {
    const int last = std::min(m, first + kPivotsAtOnce);
    if (!kernels_->eliminate_panel(M, P, m, first, last, kSingular, exchanged)) return false;
    helpers_.run(parts_of(m), static_cast<double>(P) * m * kPivotsAtOnce, [&](int part) {
      const int begin = part * kTogether;
      const int end = std::min(m, begin + kTogether);
      kernels_->apply_panel(M, P, first, last, exchanged, begin, std::min(end, first));
      kernels_->apply_panel(M, P, first, last, exchanged, std::max(begin, last), end);
    });
  }
  kernels_->undo_exchanges(M, P, m, exchanged);
  return true;
}

void Basis::refresh_duals() {
  kernels_->duals(&view_);
  view_.objective = 0;
  for (int i = 0; i < view_.m; ++i) view_.objective += view_.cost[i] * view_.x()[i];
}

double Basis::drift() const {
  double largest = 0;
  for (int k = 0; k < view_.m; ++k) {
    double residual = b_[static_cast<std::size_t>(k)];
    for (int i = 0; i < view_.m; ++i) residual -= column(i)[k] * view_.x()[i];
    if (!(std::fabs(residual) <= largest)) largest = std::fabs(residual);  // NaN stays
    if (std::isnan(largest)) break;
  }
  return largest;
}

MatrixNorms Basis::norms_together() {
  kernels_->subtract_collected(&view_);
  helpers_.run(parts_of(view_.P), cube(view_.m), [&](int part) {
    kernels_->sum_rows(&view_, part * kTogether, std::min(view_.P, (part + 1) * kTogether));
  });
  return kernels_->largest_sums(&view_);
}

const MatrixNorms& Basis::norms() {
  if (norms_pivots_ == view_.pivots) return norms_;
  norms_ = view_.m <= kTogether ? kernels_->norms(&view_) : norms_together();
  norms_pivots_ = view_.pivots;
  return norms_;
}

Enclosure Basis::enclose(bool refine) {
  const double E = residual_share();
  if (!(E < 0.5)) return {};
  if (refine) kernels_->refine(&view_, b_.data(), true);
  const double error = kernels_->refine(&view_, b_.data(), false);
  if (!std::isfinite(error)) return {};
  return {true, 1.02 * error / (1.0 - E)};
}

}  // namespace raygauge
