// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/first_basis.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace raygauge {
namespace {

constexpr double kFeasible = 1e-11;  // how negative a weight may be in a first basis
// Of near ties the interior-point method may name a few wrong columns; where so many are, the basis is none
// of an optimum.
constexpr int kMostExchanges = 40;
constexpr double kLeastPivot = 1e-9;  // of a row, relative to its largest entry

double largest_of(const double* row, int n) {
  double largest = 0;
  for (int k = 0; k < n; ++k) largest = std::max(largest, std::fabs(row[k]));
  return largest;
}

// Entry (i, k) of a matrix of the basis.
double& entry(const BasisView& basis, double* M, int i, int k) {
  return M[static_cast<std::ptrdiff_t>(k) * basis.P + i];
}

// A point q of Q with -q = |q| S_k e_k in the place of column S_k e_k, at cost 1. Returns how many there are.
int place_axis_points(const AxisPoints& axes, BasisView& view) {
  const int n = view.m - 1;
  int placed = 0;
  for (int k = 0; k < n; ++k) {
    double& diagonal = entry(view, view.B, k, k);
    const bool positive = diagonal < 0;
    const double length = axes.length(k, positive);
    if (!(length > 0)) continue;
    view.id[k] = id_of_Q(axes.index(k, positive));
    view.cost[k] = 1;
    view.y[k] = diagonal / length;
    diagonal *= length;
    entry(view, view.R, k, k) /= length;
    entry(view, view.R, k, n) /= length;
    view.x()[k] /= length;
    ++placed;
  }
  return placed;
}

struct Entering {
  std::int64_t id = -1;  // none
  double ratio = std::numeric_limits<double>::infinity();
  double pivot = 0;
  double least_pivot = 0;
};

void look_for_entering(const Kernels& kernels, const ColumnPool& pool, const double* row,
                       const BasisView& basis, bool of_Q, Entering& best) {
  const int n = basis.m - 1;
  const PricedPoints points = pool.view();
  const auto lanes = static_cast<std::size_t>(points.block_count) * PointSet::kLanes;
  AlignedBuffer<double> of_row, priced;
  of_row.reserve(lanes);
  priced.reserve(lanes);
  kernels.products(points.blocks, points.block_count, n, row, of_row.data());
  kernels.products(points.blocks, points.block_count, n, basis.y, priced.data());
  for (std::ptrdiff_t i = 0; i < points.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double pivot = of_Q ? -of_row[at] : of_row[at] + row[n];
    if (!(pivot < -best.least_pivot)) continue;
    const double reduced_cost = of_Q ? 1 + priced[at] : -(priced[at] + basis.y[n]);
    const double ratio = std::max(reduced_cost, 0.0) / -pivot;
    if (ratio > best.ratio || (ratio == best.ratio && pivot >= best.pivot)) continue;
    best = {of_Q ? id_of_Q(i) : id_of_A(i), ratio, pivot, best.least_pivot};
  }
}

}  // namespace

void FirstBasis::begin(int n, const Kernels& kernels) {
  n_ = n;
  kernels_ = &kernels;
  const auto size = static_cast<std::size_t>(padded_rows(n + 1));
  for (AlignedBuffer<double>* vector : {&column_, &guess_, &white_}) vector->reserve(size);
  single_.reserve(size);
}

// max sign · guess · p over the points, and the best of them: a start needs no more than single precision.
double FirstBasis::price_guess(const PricedPoints& points, double sign, LaneList* lanes) {
  for (int k = 0; k < n_; ++k)
    column_[static_cast<std::size_t>(k)] = sign * guess_[static_cast<std::size_t>(k)];
  return kernels_->price_lanes(&points, n_, column_.data(), single_.data(), lanes);
}

void FirstBasis::guess(const ColumnPool& A, const ColumnPool& Q, const FirstGuess& first, PointBasis& basis,
                       SimplexLoop& loop) {
  basis.reset(n_ + 1, *kernels_);
  basis.right_hand_side()[n_] = 1.0;

  // The guess, scaled to h_Q(-u) = 1 as the final normal will be.
  std::copy_n(first.normal, n_, guess_.data());
  const double h_Q = price_guess(Q.view(), -1.0, &loop.first_Q);
  const double length = h_Q > 0 ? 1.0 / h_Q : 1.0;
  price_guess(A.view(), 1.0, &loop.first_A);
  const std::int64_t index = loop.first_A.best;
  for (int k = 0; k < n_; ++k) guess_[static_cast<std::size_t>(k)] = length * first.normal[k];

  double* a = column_.data();
  basis.form_column(A, id_of_A(index), a);
  basis.set_column(n_, a, 0.0, id_of_A(index));
  place_artificials(a, first.frame, basis.view());
  set_artificial_costs(first.error, first.frame, basis.view());
  loop.artificials = n_;
  BasisView& view = basis.view();
  if (first.axes != nullptr && first.frame == nullptr)
    loop.artificials -= place_axis_points(*first.axes, view);
  view.objective = view.y[n_] = 0;
  for (int k = 0; k < n_; ++k) {
    view.objective += view.cost[k] * view.x()[k];
    view.y[n_] -= view.y[k] * a[k];
  }
}

// B = [F S, a; 0, 1] with the signs S: R = [S F⁻¹, -S F⁻¹ a; 0, 1], whose last column is x. F = I without a
// frame.
void FirstBasis::place_artificials(const double* a, const FirstGuess::Frame* frame, BasisView& view) {
  double* R_last = view.R + static_cast<std::ptrdiff_t>(n_) * view.P;
  double* white = white_.data();
  std::copy_n(a, n_, white);
  if (frame != nullptr) {
    std::fill_n(white, n_, 0.0);
    for (int k = 0; k < n_; ++k) {
      for (int i = 0; i < n_; ++i) white[i] += frame->inverse[static_cast<std::ptrdiff_t>(k) * n_ + i] * a[k];
    }
  }
  for (int k = 0; k < n_; ++k) {
    const double sign = white[k] > 0 ? -1.0 : 1.0;
    if (frame == nullptr) entry(view, view.B, k, k) = entry(view, view.R, k, k) = sign;
    for (int i = 0; i < n_ && frame != nullptr; ++i) {
      entry(view, view.B, i, k) = sign * frame->F[static_cast<std::ptrdiff_t>(k) * n_ + i];
      entry(view, view.R, k, i) = sign * frame->inverse[static_cast<std::ptrdiff_t>(i) * n_ + k];
    }
    view.id[k] = -1 - k;
    R_last[k] = -sign * white[k];
  }
  R_last[n_] = 1.0;
  std::copy_n(R_last, view.P, view.x());
}

// c_k = max(S_k F_k · guess, 0) + slack, and the duals of that basis: yᵀ F S = c.
void FirstBasis::set_artificial_costs(double guess_error, const FirstGuess::Frame* frame, BasisView& view) {
  const double* guess = guess_.data();
  double* white = white_.data();  // Fᵀ guess, then S c
  double scale = 0;
  for (int k = 0; k < n_; ++k) {
    white[k] = guess[k];
    if (frame != nullptr) {
      white[k] = std::inner_product(guess, guess + n_, frame->F + static_cast<std::ptrdiff_t>(k) * n_, 0.0);
    }
    scale = std::max(scale, std::fabs(white[k]));
  }
  for (int k = 0; k < n_; ++k) {
    const double sign = std::signbit(entry(view, view.B, k, k)) ? -1.0 : 1.0;  // F_kk > 0
    view.cost[k] = std::max(sign * white[k], 0.0) + guess_error * scale;
    white[k] = sign * view.cost[k];
  }
  for (int k = 0; k < n_; ++k) {
    view.y[k] = white[k];
    if (frame != nullptr) {
      view.y[k] =
          std::inner_product(white, white + n_, frame->inverse + static_cast<std::ptrdiff_t>(k) * n_, 0.0);
    }
  }
}

bool FirstBasis::choose(const ColumnPool& A, const ColumnPool& Q, std::span<const std::int64_t> ids,
                        const Stopwatch& stopwatch, PointBasis& basis) {
  basis.reset(n_ + 1, *kernels_);
  basis.right_hand_side()[n_] = 1.0;
  for (int i = 0; i <= n_; ++i) {
    const std::int64_t id = ids[static_cast<std::size_t>(i)];
    basis.form_column(is_from_Q(id) ? Q : A, id, column_.data());
    basis.set_column(i, column_.data(), is_from_Q(id) ? 1.0 : 0.0, id);
  }
  if (!basis.refactor()) return false;
  int exchanges = 0;
  for (;;) {
    const double* x = basis.view().x();
    const auto row = static_cast<int>(std::min_element(x, x + n_ + 1) - x);
    if (x[row] >= -kFeasible) return true;
    if (++exchanges > kMostExchanges || stopwatch.expired() || !exchange(A, Q, row, basis)) return false;
  }
}

// A dual simplex step: the column of a row with a negative weight leaves, and of those that make the weight
// positive the one enters whose reduced cost is the first to fall to zero.
bool FirstBasis::exchange(const ColumnPool& A, const ColumnPool& Q, int row, PointBasis& basis) {
  BasisView& view = basis.view();
  std::vector<double> row_of_inverse(static_cast<std::size_t>(n_) + 1);
  for (int k = 0; k <= n_; ++k) row_of_inverse[static_cast<std::size_t>(k)] = entry(view, view.R, row, k);
  Entering best;
  best.least_pivot = kLeastPivot * largest_of(row_of_inverse.data(), n_ + 1);
  look_for_entering(*kernels_, A, row_of_inverse.data(), view, false, best);
  look_for_entering(*kernels_, Q, row_of_inverse.data(), view, true, best);
  if (best.id < 0) return false;
  const bool of_Q = is_from_Q(best.id);
  basis.form_column(of_Q ? Q : A, best.id, column_.data());
  using Columns = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  Columns R(view.R, n_ + 1, n_ + 2, Eigen::OuterStride<>(view.P));  // with x
  const Eigen::VectorXd w = R.leftCols(n_ + 1) * Eigen::Map<const Eigen::VectorXd>(column_.data(), n_ + 1);
  if (!(w[row] < 0)) return false;
  const Eigen::RowVectorXd scaled = R.row(row) / w[row];
  R.noalias() -= w * scaled;
  R.row(row) = scaled;
  basis.set_column(row, column_.data(), of_Q ? 1.0 : 0.0, best.id);
  ++view.pivots;
  basis.refresh_duals();
  return true;
}

}  // namespace raygauge
