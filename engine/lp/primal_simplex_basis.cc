// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// A first basis of given columns, made feasible by dual simplex steps.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/lp/primal_simplex.h"
#include "engine/numerics/aligned_buffer.h"

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

}  // namespace

bool PrimalSimplex::start_from(const ColumnPool& A, const ColumnPool& Q, std::span<const std::int64_t> ids,
                               const Stopwatch& stopwatch) {
  if (std::ssize(ids) != n_ + 1) return false;
  basis_.reset(n_ + 1, *kernels_);
  basis_.right_hand_side()[n_] = 1.0;
  for (int i = 0; i <= n_; ++i) {
    const std::int64_t id = ids[static_cast<std::size_t>(i)];
    form_column(is_from_Q(id) ? Q : A, id);
    basis_.set_column(i, column_.data(), is_from_Q(id) ? 1.0 : 0.0, id);
  }
  ++refactorisations_;
  loop_.artificials = 0;
  loop_.first_A.count = 0;
  if (!basis_.refactor()) return false;
  int exchanges = 0;
  for (;;) {
    const double* x = basis_.view().x();
    const auto row = static_cast<int>(std::min_element(x, x + n_ + 1) - x);
    if (x[row] >= -kFeasible) return true;
    if (++exchanges > kMostExchanges || stopwatch.expired() || !exchange(A, Q, row)) return false;
  }
}

// A dual simplex step: the column of a row with a negative weight leaves, and of those that make the weight
// positive the one enters whose reduced cost is the first to fall to zero.
bool PrimalSimplex::exchange(const ColumnPool& A, const ColumnPool& Q, int row) {
  BasisView& view = basis_.view();
  const auto size = static_cast<std::size_t>(n_) + 1;
  std::vector<double> row_of_inverse(size);
  for (std::size_t k = 0; k < size; ++k)
    row_of_inverse[k] = view.R[static_cast<std::ptrdiff_t>(k) * view.P + row];
  Entering best;
  best.least_pivot = kLeastPivot * largest_of(row_of_inverse.data(), n_ + 1);
  look_for_entering(A, row_of_inverse.data(), false, best);
  look_for_entering(Q, row_of_inverse.data(), true, best);
  if (best.id < 0) return false;
  const bool of_Q = is_from_Q(best.id);
  form_column(of_Q ? Q : A, best.id);
  using Columns = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  Columns R(view.R, n_ + 1, n_ + 2, Eigen::OuterStride<>(view.P));  // with x
  const Eigen::VectorXd w = R.leftCols(n_ + 1) * Eigen::Map<const Eigen::VectorXd>(column_.data(), n_ + 1);
  if (!(w[row] < 0)) return false;
  const Eigen::RowVectorXd scaled = R.row(row) / w[row];
  R.noalias() -= w * scaled;
  R.row(row) = scaled;
  basis_.set_column(row, column_.data(), of_Q ? 1.0 : 0.0, best.id);
  ++view.pivots;
  basis_.refresh_duals();
  return true;
}

void PrimalSimplex::look_for_entering(const ColumnPool& pool, const double* row, bool of_Q, Entering& best) {
  const PricedPoints points = pool.view();
  const auto lanes = static_cast<std::size_t>(points.block_count) * PointSet::kLanes;
  AlignedBuffer<double> in_row, priced;
  in_row.reserve(lanes);
  priced.reserve(lanes);
  kernels_->products(points.blocks, points.block_count, n_, row, in_row.data());
  kernels_->products(points.blocks, points.block_count, n_, normal(), priced.data());
  for (std::ptrdiff_t i = 0; i < points.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double pivot = of_Q ? -in_row[at] : in_row[at] + row[n_];
    if (!(pivot < -best.least_pivot)) continue;
    const double reduced_cost = of_Q ? 1 + priced[at] : -(priced[at] + normal()[n_]);
    const double ratio = std::max(reduced_cost, 0.0) / -pivot;
    if (ratio > best.ratio || (ratio == best.ratio && pivot >= best.pivot)) continue;
    best.ratio = ratio;
    best.pivot = pivot;
    best.id = of_Q ? id_of_Q(i) : id_of_A(i);
  }
}

}  // namespace raygauge
